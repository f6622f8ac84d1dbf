package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.joml.Vector3dc;
import tompkins.measure.Fact.Flag;
import tompkins.measure.Fact.Group;
import tompkins.measure.Fact.Items;
import tompkins.measure.Fact.Vector;
import tompkins.measure.Fact.Word;
import tompkins.ray.Colour;
import tompkins.spacetime.Event;
import tompkins.spacetime.IdentityTransformation;
import tompkins.spacetime.LightInMedium;
import tompkins.spacetime.SpeedScale;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.trace.FlashSight;
import tompkins.trace.Frame;
import tompkins.trace.SampleHistory;

/** What is told about a ray: where it starts, all that it meets, and the light that comes back. */
public final class RayHistory {

    private static final String DOPPLER_FACTOR = "Doppler factor (camera/scene)";

    private RayHistory() {}

    /**
     * The history of a ray, followed backwards in time. Each hit is told in the frame in which it was found, with its
     * distance there, in those of the camera and the scene, and in the rest frame of its object; normals are those of
     * the rest frame. Programs are told nothing of a ray that never crosses the shutter, and nothing of the scene if it
     * never enters that. If the camera overtakes other light in the same direction, that is told, too.
     */
    public static List<Fact> of(Sighting sighting) {
        SampleHistory life = sighting.life();
        if (life == null) {
            return List.of(heading("This ray never crosses the shutter: it brings no light and has no events"));
        }
        Studio studio = sighting.studio();
        List<Fact> facts = new ArrayList<>();
        facts.add(new Group("camera", "Starts in the camera frame", start(life.cameraStart(), life.cameraDirection())));
        if (life.sceneStart() != null) {
            facts.add(new Group("scene", "", start(life.sceneStart(), life.sceneDirection())));
        }
        facts.add(number("frequencyRatio", "", life.sceneDopplerFactor()));
        if (life.overtaken() != null) {
            facts.add(overtaken(life.overtaken()));
        }
        SpeedScale scale = studio.transformation().speedScale();
        facts.add(number(scale.key(), "", scale.valueOf(studio.velocity())));
        facts.add(new Items("hits", events(life, studio)));
        if (life.hitsLeftOut() > 0) {
            facts.add(number("hitsLeftOut", "Hits left out before the last", life.hitsLeftOut()));
        }
        if (life.end() == null) {
            facts.add(heading(
                    life.reachesBackground()
                            ? "Meets nothing else: the background"
                            : "No light comes from there: the camera is as fast as light in what is around it, or"
                                    + " faster"));
        }
        if (life.reachesBackground() && studio.background() instanceof StarSky sky) {
            StarSighting.nearest(sky, life.lastDirection()).ifPresent(star -> facts.add(star.fact(studio, sky, life)));
        }
        Colour colour = life.colour();
        facts.add(new Vector("colour", "Colour (linear)", List.of(colour.red(), colour.green(), colour.blue())));
        return facts;
    }

    private static Group overtaken(LightInMedium.Seen light) {
        return new Group(
                "overtaken",
                "Left out: light that the camera overtakes in this direction",
                List.of(
                        new Vector("ownDirection", "direction (medium)", light.direction()),
                        number("frequencyRatio", "Doppler factor (camera/medium)", light.frequency())));
    }

    /** All hits, and between them the entry into the scene frame. */
    private static List<Group> events(SampleHistory life, Studio studio) {
        List<Group> events = new ArrayList<>();
        boolean entered = life.sceneStart() == null;
        for (SampleHistory.Encounter hit : life.hits()) {
            if (!entered && hit.branch() == 0 && hit.frame() == Frame.SCENE) {
                events.add(entry(life, studio));
                entered = true;
            }
            events.add(hit(hit, studio));
        }
        if (!entered) {
            events.add(entry(life, studio));
        }
        return events;
    }

    private static Group entry(SampleHistory life, Studio studio) {
        List<Fact> facts = new ArrayList<>(start(life.sceneStart(), life.sceneDirection()));
        facts.add(
                studio.view() == View.MEASURED
                        ? new Word("", DOPPLER_FACTOR, "none: measured at one time of the camera, without light")
                        : number("", DOPPLER_FACTOR, life.sceneDopplerFactor()));
        SpeedScale scale = studio.transformation().speedScale();
        facts.add(number("", scale.key(), scale.valueOf(studio.velocity())));
        return new Group("", "Enters the scene frame", facts);
    }

    private static List<Fact> start(Event event, Vector3dc direction) {
        return with(event("time", "time", event), new Vector("direction", "direction", direction));
    }

    private static Group hit(SampleHistory.Encounter hit, Studio studio) {
        boolean inScene = hit.frame() == Frame.SCENE;
        boolean moves = !(studio.sceneFromCamera() instanceof IdentityTransformation);
        SampleHistory.Rest rest = hit.rest();
        List<Fact> facts = new ArrayList<>();
        facts.add(new Word("object", "", hit.object().description()));
        facts.add(new Word("frame", "", name(hit.frame())));
        facts.add(new Vector("position", "", hit.event().position()));
        facts.add(number("time", "", hit.event().time()));
        facts.add(number("distance", "distance (" + name(hit.frame()) + ")", hit.distance()));
        facts.add(number("share", hit.fraction() < 1 ? "throughput" : "", hit.fraction()));
        facts.add(number("branch", "", hit.branch()));
        facts.add(new Word("surface", "surface", hit.surface().getClass().getSimpleName()));
        facts.add(new Vector("normal", "", rest.normal()));
        facts.add(new Vector("surfaceCoordinates", "", List.of(rest.u(), rest.v())));
        facts.add(new Group(
                "camera",
                moves || !inScene ? "camera frame" : "",
                event("time", "time", hit.inCamera(studio.sceneFromCamera()))));
        facts.add(new Group(
                "scene",
                moves || inScene ? "scene frame" : "",
                event("time", "time", hit.inScene(studio.sceneFromCamera()))));
        List<Fact> own = with(
                event("properTime", "proper time", rest.event()),
                number(
                        "clockReading",
                        rest.clockReading() == rest.event().time() ? "" : "clock reading",
                        rest.clockReading()),
                number(
                        "frequencyRatio",
                        Double.isNaN(rest.dopplerFactor()) ? "" : "Doppler factor (camera/object)",
                        rest.dopplerFactor()));
        if (rest.velocity() != null) {
            own.add(new Vector("velocity", "velocity round the axis", rest.velocity()));
        }
        facts.add(new Group("own", hit.movesByItself() ? "rest frame" : "", own));
        hit.flashes().forEach(flash -> facts.add(flash(flash)));
        return new Group("hit", "Hits " + hit.object().description(), facts);
    }

    /** Whether the light that gets to a hit from a lamp belongs to one of its flashes. */
    private static Group flash(FlashSight sight) {
        List<Fact> facts = new ArrayList<>();
        facts.add(number("emission", "left at own time", sight.emission()));
        facts.add(new Flag("on", "", sight.isLit()));
        facts.add(new Word("", "lamp", sight.isLit() ? "on" : "off"));
        if (sight.flash().period() > 0) {
            facts.add(number("flash", "number of the flash", sight.flash().cycle(sight.emission())));
        }
        return new Group("lamp" + sight.lamp(), "light of lamp " + sight.lamp() + " left at", facts);
    }

    private static Group heading(String words) {
        return new Group("", words, List.of());
    }

    private static List<Fact> event(String key, String name, Event event) {
        return List.of(new Vector("position", "position", event.position()), number(key, name, event.time()));
    }

    private static List<Fact> with(List<Fact> facts, Fact... more) {
        List<Fact> all = new ArrayList<>(facts);
        all.addAll(List.of(more));
        return all;
    }

    private static Quantity number(String key, String name, double value) {
        return Quantity.exact(key, name, "", value);
    }

    private static String name(Frame frame) {
        return frame.name().toLowerCase(Locale.ROOT);
    }
}
