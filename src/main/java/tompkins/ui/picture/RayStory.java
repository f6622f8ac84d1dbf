package tompkins.ui.picture;

import java.util.ArrayList;
import java.util.List;
import tompkins.trace.Frame;
import tompkins.trace.RayLife;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Texts;

/** The life of a ray in words, followed backwards in time: what the command "trace" prints, for the window. */
public final class RayStory {

    /**
     * Something that happens to the ray.
     *
     * @param heading what happens
     * @param branch 0 on the main branch, more on weaker ones, as in {@link RayLife.Encounter}
     * @param facts where, when, and how
     */
    public record Step(String heading, int branch, List<Fact> facts) {}

    /**
     * A fact under a heading.
     *
     * @param label what it is
     * @param value what there is to know
     */
    public record Fact(String label, String value) {}

    private RayStory() {}

    /** The story of what was read, its beginning and its colour first. */
    public static List<Step> of(PixelProbe.Reading reading) {
        List<Step> steps = new ArrayList<>();
        RayLife life = reading.life();
        String pixel = Texts.get("probe.pixel", reading.column(), reading.row());
        if (life == null) {
            steps.add(new Step(pixel + ": " + Texts.get("probe.noShutter"), 0, List.of()));
            return steps;
        }
        steps.add(new Step(
                pixel, 0, List.of(fact("colour", colour(life)), fact("followed", Texts.get("ray.backwards")))));
        steps.add(new Step(
                Texts.get("ray.cameraStart"),
                0,
                List.of(
                        fact("at", Numbers.brief(life.cameraStart())),
                        fact("direction", Numbers.brief(life.cameraDirection())))));
        boolean crossed = false;
        for (RayLife.Encounter hit : life.hits()) {
            if (!crossed && hit.branch() == 0 && hit.frame() == Frame.SCENE) {
                crossed = true;
                steps.add(crossing(life));
            }
            steps.add(hit(hit, hit == life.end() ? reading : null));
        }
        if (!crossed && life.sceneStart() != null) {
            steps.add(crossing(life));
        }
        if (life.end() == null) {
            steps.add(
                    new Step(Texts.get(life.reachesBackground() ? "ray.background" : "ray.standsStill"), 0, List.of()));
        }
        return steps;
    }

    private static String colour(RayLife life) {
        return Numbers.brief(life.colour().red(), 4)
                + ", " + Numbers.brief(life.colour().green(), 4)
                + ", " + Numbers.brief(life.colour().blue(), 4);
    }

    private static Step crossing(RayLife life) {
        String frequency = Double.isNaN(life.frequencyRatio())
                ? Texts.get("ray.measured")
                : Texts.get("ray.ratio", Numbers.brief(life.frequencyRatio()));
        return new Step(
                Texts.get("ray.sceneStart"),
                0,
                List.of(
                        fact("at", Numbers.brief(life.sceneStart())),
                        fact("direction", Numbers.brief(life.sceneDirection())),
                        fact("frequency", frequency)));
    }

    /**
     * A hit in the frame in which it was found; in that of the scene and that of the camera if the ray ends there; and
     * for what moves by itself also in its own frame.
     */
    private static Step hit(RayLife.Encounter hit, PixelProbe.Reading read) {
        List<Fact> facts = new ArrayList<>();
        facts.add(fact("distance", Numbers.brief(hit.distance())));
        if (read != null) {
            facts.add(fact("inScene", Numbers.brief(read.inScene())));
            facts.add(fact("inCamera", Numbers.brief(read.inCamera())));
        } else {
            facts.add(fact(hit.frame() == Frame.SCENE ? "inScene" : "inCamera", Numbers.brief(hit.event())));
        }
        if (hit.movesByItself()) {
            facts.addAll(ownFrame(hit.rest()));
        }
        if (hit.share() < 1) {
            facts.add(fact("share", Texts.get("ray.atMost", Numbers.brief(hit.share(), 4))));
        }
        return new Step(Texts.get("ray.hits", hit.object().description()), hit.branch(), facts);
    }

    /** A hit in the frame in which its object rests; what its clocks show is included only if they were set. */
    private static List<Fact> ownFrame(RayLife.Rest rest) {
        List<Fact> facts = new ArrayList<>();
        facts.add(fact("inOwn", Numbers.brief(rest.event().position())));
        facts.add(fact("properTime", Numbers.brief(rest.event().time())));
        if (rest.clockReading() != rest.event().time()) {
            facts.add(fact("clock", Numbers.brief(rest.clockReading())));
        }
        if (!Double.isNaN(rest.dopplerFactor())) {
            facts.add(fact("frequency", Texts.get("ray.ownRatio", Numbers.brief(rest.dopplerFactor()))));
        }
        return facts;
    }

    private static Fact fact(String label, String value) {
        return new Fact(Texts.get("ray.label." + label), value);
    }
}
