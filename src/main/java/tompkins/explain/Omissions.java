package tompkins.explain;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tompkins.camera.Camera;
import tompkins.camera.ThinLensCamera;
import tompkins.light.AmbientLight;
import tompkins.light.PointLight;
import tompkins.property.Descriptions;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.studio.Studio;
import tompkins.surface.Clear;
import tompkins.surface.Continuation;
import tompkins.surface.FrameWindow;
import tompkins.surface.Shadow;
import tompkins.surface.Surface;
import tompkins.trace.RenderPlan;

/** Says in sentences which parts of nature a picture leaves out, if that could be seen in it. */
final class Omissions {

    private final RenderPlan plan;
    private final Studio studio;
    private final Camera camera;
    private final Set<Surface> inScene;
    private final Set<Surface> beforeLens;

    /**
     * The omissions of a picture.
     *
     * @param inScene the surfaces of the scene
     * @param beforeLens the surfaces that move with the camera
     */
    Omissions(RenderPlan plan, Set<Surface> inScene, Set<Surface> beforeLens) {
        this.plan = plan;
        this.studio = plan.studio();
        this.camera = studio.camera();
        this.inScene = inScene;
        this.beforeLens = beforeLens;
    }

    /** The sentences; those that do not concern the picture are left out. */
    List<String> sentences() {
        List<String> sentences = new ArrayList<>();
        addWindows(sentences);
        addLenses(sentences);
        boolean isFocused = camera.hasWideAperture() || camera.shutter().needsFocus();
        if (isFocused && has(beforeLens, part -> part.continuation() == Continuation.TURNED)) {
            sentences.add("The focus ignores windows, glass and mirrors before the lens:"
                    + " it lies where the rays would meet it without them.");
        }
        if (!plan.isStill() && !plan.blursInTime()) {
            sentences.add("The shutter opens for an instant: nothing is blurred by motion.");
        }
        if (plan.world().followsCamera() && !beforeLens.isEmpty()) {
            sentences.add("Image points ignore the objects that move with the camera.");
        }
        addLight(sentences);
        return sentences;
    }

    private void addWindows(List<String> sentences) {
        if (!has(FrameWindow.class::isInstance)) {
            return;
        }
        boolean manyTimes = !plan.isAtRest() && !(camera.shutter() instanceof AperturePlaneShutter);
        if (camera.hasWideAperture() || manyTimes) {
            sentences.add("Windows give light the right directions, but not the right positions: "
                    + (camera.hasWideAperture()
                            ? "through a wide aperture"
                            : "with a shutter that opens at different times for different rays")
                    + " the rays cross a window at different events, and each goes on from its own.");
        }
        if (studio.shiftsColours()) {
            sentences.add("Windows turn light and leave its frequency as it is.");
        }
    }

    private void addLenses(List<String> sentences) {
        String turning = Stream.concat(inScene.stream(), beforeLens.stream())
                .flatMap(Surface::parts)
                .filter(part -> !part.keepsPhase() && !(part instanceof FrameWindow))
                .map(part -> Descriptions.name(part.getClass()))
                .distinct()
                .sorted()
                .collect(Collectors.joining(", "));
        if (!turning.isEmpty()) {
            sentences.add("Some surfaces turn light and do nothing else to it: " + turning
                    + ". A wave would be delayed there, and a part of it mirrored.");
        }
    }

    private void addLight(List<String> sentences) {
        boolean isLit = !inScene.isEmpty() || !beforeLens.isEmpty();
        if (isLit && studio.lights().stream().anyMatch(PointLight.class::isInstance)) {
            sentences.add("Lamps do not get fainter with distance.");
            if (has(part -> part.shadow() == Shadow.NEVER && !(part instanceof Clear))) {
                sentences.add("Filters, glass and windows throw no shadow and do not tint the light of lamps.");
            }
        }
        boolean shifts = isLit && studio.shiftsColours() && studio.hasMotion();
        if (shifts && studio.lights().stream().anyMatch(AmbientLight.class::isInstance)) {
            sentences.add(
                    "Ambient light is the same in every frame, as if moving objects brought their surroundings along.");
        }
        if (camera instanceof ThinLensCamera) {
            sentences.add("The picture does not get darker towards its edges: no cos^4 law, which real lenses follow.");
        }
    }

    private boolean has(Predicate<Surface> property) {
        return has(inScene, property) || has(beforeLens, property);
    }

    private static boolean has(Set<Surface> surfaces, Predicate<Surface> property) {
        return surfaces.stream().flatMap(Surface::parts).anyMatch(property);
    }
}
