package tompkins.explain;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tompkins.camera.EyeView;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.Stereo;
import tompkins.camera.StereoLayout;
import tompkins.camera.ThinLensCamera;
import tompkins.light.ColourLaw;
import tompkins.light.LightShift;
import tompkins.light.Metering;
import tompkins.light.StarCatalogue;
import tompkins.primitive.BoxPrimitive;
import tompkins.primitive.FlatPrimitive;
import tompkins.primitive.PlanePrimitive;
import tompkins.primitive.Primitive;
import tompkins.property.NumberText;
import tompkins.ray.Ray;
import tompkins.search.ObjectTree;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.RollingShutter;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.studio.FrontWindow;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.surface.Continuation;
import tompkins.surface.FrameWindow;
import tompkins.surface.IdealLens;
import tompkins.surface.LorentzWindow;
import tompkins.surface.Surface;
import tompkins.surface.WindowAxes;
import tompkins.trace.RenderPlan;
import tompkins.world.World;

/** Says in sentences what a picture models and what it leaves out. */
public final class Explanation {

    /** Above this Lorentz factor of a point that turns the user is warned. */
    private static final double MOST_GAMMA = 1000;

    private final RenderPlan plan;
    private final Studio studio;
    private final World world;
    private final ObjectTree cameraFrame;

    /** Null if the light of the scene stays as it is. */
    private final LightShift shift;

    /** Of the picture that is planned. */
    public Explanation(RenderPlan plan) {
        this.plan = plan;
        studio = plan.studio();
        world = plan.world();
        cameraFrame = plan.objectsBeforeLens();
        shift = plan.lightShift();
    }

    /** What the picture needs, what it leaves out, and why; the warnings last. */
    public List<String> sentences() {
        List<String> sentences = new ArrayList<>();
        Set<Surface> inScene = IntStream.range(0, world.frames().size())
                .mapToObj(i -> world.objects(i).surfaces())
                .flatMap(Set::stream)
                .collect(Collectors.toSet());
        Set<Surface> beforeLens = cameraFrame.surfaces();
        boolean isMeasured = studio.view() == View.MEASURED;
        if (isMeasured) {
            sentences.add(measured());
        }
        sentences.add(motion());
        sentences.add(lens());
        stereo().ifPresent(sentences::add);
        if (!isMeasured) {
            sentences.addAll(plan.mediumSentences());
        }
        if (!isMeasured) {
            sentences.add(shutter());
        }
        rolling().ifPresent(sentences::add);
        exposure().ifPresent(sentences::add);
        sentences.addAll(new Flashes(plan).sentences());
        sentences.add(colours());
        stars().ifPresent(sentences::add);
        sentences.add(cameraObjects());
        FrontWindow.of(studio).map(this::frontWindow).ifPresent(sentences::add);
        search().ifPresent(sentences::add);
        rotation().ifPresent(sentences::add);
        sentences.add(recursion(Stream.of(inScene, beforeLens).flatMap(Set::stream)));
        sentences.addAll(new Omissions(plan, inScene, beforeLens).sentences());
        warnings().forEach(warning -> sentences.add("Warning: " + warning + "."));
        return sentences;
    }

    private String measured() {
        boolean together = studio.camera().shutter() instanceof AperturePlaneShutter
                && !studio.camera().rollingShutter().rolls()
                && !plan.blursInTime();
        String time = together
                ? "at the time " + NumberText.of(studio.camera().shutter().openingTime()) + " of the camera's frame"
                : "in the camera's frame, for each ray at the time that the shutter gives";
        return "Measured, not a photograph: it shows where things are " + time
                + ", as rulers and clocks find them there. Light needs no time to the camera, but travels as usual"
                + " from the lamps, and after mirrors and glass.";
    }

    /** What may be wrong with the picture, in clauses without a full stop; the sentences contain all of them. */
    public List<String> warnings() {
        List<String> warnings = new ArrayList<>();
        studio.transformation().warning(studio.velocity()).ifPresent(warnings::add);
        IntStream.range(1, world.frames().size())
                .mapToObj(i -> world.frames().get(i).motion())
                .max(Comparator.comparingDouble(FrameMotion::gamma))
                .flatMap(studio.transformation()::warning)
                .ifPresent(warnings::add);
        double fastest = rotationSpeeds().max().orElse(0);
        if (studio.transformation() == TransformationLaw.LORENTZ && gamma(fastest) > MOST_GAMMA) {
            warnings.add(format(
                    "something turns with a gamma of %s at its edge, above %s; its hits may be wrong there",
                    NumberText.of(NumberText.rounded(gamma(fastest), 3)), NumberText.of(MOST_GAMMA)));
        }
        if (shift != null && shift.isTooFaint()) {
            warnings.add(
                    "the light of the scene is too faint to be seen in the middle of the picture, which stays dark");
        }
        new Flashes(plan).warning().ifPresent(warnings::add);
        BrightColours.warning(studio).ifPresent(warnings::add);
        Stream.concat(IntStream.range(0, world.frames().size()).mapToObj(world::objects), Stream.of(cameraFrame))
                .filter(objects -> objects.surfaces().stream().anyMatch(Explanation::isLens))
                .flatMap(objects -> objects.primitives().stream())
                .filter(primitive -> isRound(primitive) && isLens(primitive.surface()))
                .findFirst()
                .ifPresent(lens -> warnings.add("an IdealLens is for flat objects; \"" + lens.description()
                        + "\" is round, and what is seen through it means nothing"));
        if (missesFocus()) {
            warnings.add("the focus has no surface, so that "
                    + (studio.camera().shutter().needsFocus()
                            ? "no ray crosses the shutter"
                            : "everything is focused at infinity"));
        }
        return warnings;
    }

    private static boolean isLens(Surface surface) {
        return surface.parts().anyMatch(IdealLens.class::isInstance);
    }

    private static boolean isRound(Primitive primitive) {
        return !(primitive instanceof FlatPrimitive
                || primitive instanceof PlanePrimitive
                || primitive instanceof BoxPrimitive);
    }

    /** Whether the picture needs a focus, and there is none, as in an empty group. */
    private boolean missesFocus() {
        return studio.camera() instanceof ThinLensCamera camera
                && camera.surfaceInFocus().primitiveCount() == 0
                && (camera.hasWideAperture() || camera.shutter().needsFocus());
    }

    private String motion() {
        if (studio.velocity().isRest()) {
            return "The camera is at rest: no change of frame"
                    + (plan.isStill() ? ", and every opening time gives the same picture." : ".");
        }
        SpeedScale scale = studio.transformation().speedScale();
        String speed = scale.key() + " " + scale.reading(studio.velocity());
        if (studio.transformation() == TransformationLaw.NONE) {
            return "The camera's velocity (" + speed + ") is ignored: no change of frame.";
        }
        String law = studio.transformation() == TransformationLaw.LORENTZ ? "Lorentz" : "Galilean";
        return "The camera moves (" + speed + "): each ray goes once through the " + law
                + " transformation, at its last event in the camera frame.";
    }

    private String lens() {
        if (studio.camera().hasWideAperture()) {
            return "A wide aperture: the focus decides what is sharp.";
        }
        return "A pinhole: one point of the lens, everything is sharp"
                + (studio.camera().shutter().needsFocus()
                        ? "; the focus only sets the time."
                        : "; the focus does not matter.");
    }

    private Optional<String> stereo() {
        Stereo stereo = studio.camera().stereo();
        if (stereo.layout() == StereoLayout.NONE) {
            return Optional.empty();
        }
        return Optional.of(format(
                "Stereo, %s: the eyes rest in the camera frame, %s apart, and both show what is %s straight ahead in the"
                        + " middle of their pictures.%s%s",
                stereo.layout().name().toLowerCase(Locale.ROOT).replace('_', ' '),
                NumberText.of(stereo.eyeDistance()),
                NumberText.of(stereo.zeroParallaxDistance()),
                studio.camera() instanceof PanoramicCamera
                        ? " They turn about the camera's position with the columns, each of which they see straight ahead."
                        : "",
                stereo.layout().isAnaglyph()
                        ? " Each sample follows a ray of each eye; the ray that is traced for a point is that of the left"
                                + " eye."
                        : ""));
    }

    private String shutter() {
        if (plan.isStill()) {
            return "Nothing in the scene changes with time: every shutter model gives this picture, except where a ray"
                    + " never crosses the shutter.";
        }
        if (studio.camera().shutter() instanceof AperturePlaneShutter shutter) {
            boolean together = !studio.camera().rollingShutter().rolls();
            if (plan.blursInTime()) {
                return format(
                        "At each moment of the exposure all light%s crosses the lens at the same time.",
                        together ? "" : " of a line");
            }
            boolean atOrigin = shutter.openingTime() == 0
                    && together
                    && cameraFrame.size() == 0
                    && !studio.camera().hasWideAperture()
                    && studio.camera().position().length() == 0
                    && studio.camera().stereo().layout() == StereoLayout.NONE;
            return atOrigin
                    ? "All light crosses the pinhole at time 0, where the origins of both frames meet: only directions"
                            + " change (aberration), not the point of view."
                    : format("All light%s crosses the lens at the same time.", together ? "" : " of a line");
        }
        return "Each ray crosses the lens at its own time, so pixels can have different viewpoints in the scene.";
    }

    private Optional<String> rolling() {
        RollingShutter rolling = studio.camera().rollingShutter();
        if (!rolling.rolls() || plan.isStill()) {
            return Optional.empty();
        }
        EyeView view = plan.pictureRays().views().get(0);
        int lines = rolling.direction().runsOverRows() ? view.height() : view.width();
        return Optional.of(format(
                "The shutter rolls %s: each of %d lines opens %s after the one before it, which is free.",
                rolling.direction().name().toLowerCase(Locale.ROOT),
                lines,
                NumberText.plain(rolling.sweep() / lines, 3)));
    }

    private Optional<String> exposure() {
        if (!plan.blursInTime()) {
            return Optional.empty();
        }
        double length = MotionBlur.length(plan, plan.middle().x(), plan.middle().y());
        return Optional.of(format(
                "The shutter stays open for %s: what the middle of the picture shows moves by %s meanwhile. This is free;"
                        + " smooth blur needs more samples.",
                NumberText.of(studio.camera().exposureTime()),
                Double.isFinite(length) ? NumberText.plain(length, 2) + " pixels" : "an unknown length"));
    }

    private Optional<String> stars() {
        if (!(studio.background() instanceof StarSky sky)) {
            return Optional.empty();
        }
        String change = !studio.shiftsColours()
                ? "Motion moves them and leaves them as bright as they are."
                : (studio.colours() == ColourLaw.SEARCHLIGHT
                                ? "A star gets brighter with the square of the Doppler factor D."
                                : "A star is seen as a black body of D times its temperature.")
                        + " Stars that are fainter at rest are left out, although the motion would make many of them"
                        + " visible ahead.";
        return Optional.of(format(
                "The sky holds %d stars, to magnitude %s at rest; each is a spot of a few pixels with all its light,"
                        + " whatever the size of the picture. %s",
                StarCatalogue.upTo(sky.limit()).size(), NumberText.of(sky.limit()), change));
    }

    private String cameraObjects() {
        int count = cameraFrame.size();
        return count == 0
                ? "Nothing moves with the camera: only the scene is searched."
                : format(
                        "%d primitive%s with the camera and %s drawn in front of everything in the scene.",
                        count, count == 1 ? " moves" : "s move", count == 1 ? "is" : "are");
    }

    private String frontWindow(FrameWindow window) {
        TransformationLaw law =
                window instanceof LorentzWindow ? TransformationLaw.LORENTZ : TransformationLaw.GALILEAN;
        String turns = "The window in front of the lens turns light ";
        if (law == studio.transformation() && FrontWindow.matches(studio) && window.axes() == WindowAxes.FRAME) {
            return turns + "back into the direction that it has in the scene: the aberration is undone.";
        }
        return turns
                + format(
                        "as a %s change of frame with its own velocity does%s.",
                        law == TransformationLaw.LORENTZ ? "Lorentz" : "Galilean",
                        studio.velocity().isRest() ? "" : "; the aberration of the camera is not undone");
    }

    private Optional<String> search() {
        if (world.frames().size() > 1) {
            return Optional.of(searchInFrames());
        }
        return world.objects(0).size() > 0
                ? Optional.empty()
                : Optional.of("The scene holds no objects: rays that reach it see the background.");
    }

    private String searchInFrames() {
        SpeedScale scale = studio.transformation().speedScale();
        double fastest = IntStream.range(1, world.frames().size())
                .mapToDouble(i -> scale.valueOf(world.frames().get(i).motion().velocity()))
                .max()
                .orElseThrow();
        return format(
                "%d inertial frames: each ray is searched for in every one that holds objects; the fastest moves with %s"
                        + " %s.",
                world.frames().size(), scale.key(), NumberText.of(NumberText.rounded(fastest, 4)));
    }

    private DoubleStream rotationSpeeds() {
        return IntStream.range(0, world.frames().size())
                .mapToObj(frame -> world.objects(frame).rotationSpeeds())
                .flatMap(List::stream)
                .mapToDouble(Double::doubleValue);
    }

    private Optional<String> rotation() {
        long groups = rotationSpeeds().count();
        double fastest = rotationSpeeds().max().orElse(0);
        return groups == 0
                ? Optional.empty()
                : Optional.of(format(
                        "%s: rays are curves among what turns; the fastest point runs with %s c round its axis%s.",
                        groups == 1 ? "One group of objects turns" : groups + " groups of objects turn",
                        NumberText.plain(fastest, 4),
                        studio.transformation() == TransformationLaw.LORENTZ
                                ? ", gamma " + NumberText.plain(gamma(fastest), 4)
                                : ""));
    }

    private static double gamma(double speed) {
        return 1 / Math.sqrt((1 - speed) * (1 + speed));
    }

    private String recursion(Stream<Surface> surfaces) {
        boolean continues = surfaces.anyMatch(surface -> surface.continuation() != Continuation.NONE);
        return continues
                ? format(
                        "Some surfaces send rays on: at most %d times, and only while these carry at least 1/%.0f of the light.",
                        studio.settings().maximumDepth(), 1 / Ray.FAINTEST)
                : "No mirrors, glass, windows or filters: each ray ends where it hits.";
    }

    private String colours() {
        if (shift == null) {
            return "Colours stay as they are in the scene: no Doppler shift, no searchlight effect" + reason();
        }
        String change = shift.law() == ColourLaw.DOPPLER
                ? "Colours and brightness shift with the Doppler factor D (frequency in the camera/scene), as in the light"
                        + " of a black body"
                : "The searchlight effect alone: brightness changes with the fourth power of the Doppler factor D (frequency"
                        + " in the camera/scene)";
        if (shift.metering() == Metering.NONE) {
            return change + ". The light of the scene is taken as it comes, without metering.";
        }
        return format(
                "%s. The light of the scene is metered in the middle of the picture, where D is %s: %+.1f stops.",
                change, NumberText.plain(shift.middle(), 4), Math.round(10 * shift.stops()) / 10.0);
    }

    /** Why colours stay as they are, if the scene wants something else; ends the sentence. */
    private String reason() {
        boolean unwanted =
                studio.colours() == ColourLaw.UNCHANGED || studio.velocity().isRest() && !studio.hasMotion();
        if (unwanted) {
            return ".";
        }
        return studio.transformation() == TransformationLaw.LORENTZ
                ? "; what is measured has no Doppler factor."
                : "; they change under the Lorentz transformation only.";
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
