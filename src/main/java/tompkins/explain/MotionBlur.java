package tompkins.explain;

import org.joml.Vector2dc;
import tompkins.camera.Camera;
import tompkins.measure.Projection;
import tompkins.shutter.Shutter;
import tompkins.studio.Studio;
import tompkins.trace.Frame;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;
import tompkins.world.FrameAppearance;

/** How far what is seen moves across the picture while the shutter is open. */
final class MotionBlur {

    private MotionBlur() {}

    /**
     * The distance, in pixels, between the places at which the beginning and the end of the exposure show what is seen
     * at a point of the picture: 0 for the background and for what moves with the camera. NaN if it is not known: for
     * what turns or gets out of sight, and for shutters without an opening time. Of what is seen in mirrors and through
     * glass, these count.
     */
    static double length(RenderPlan plan, double x, double y) {
        SampleHistory history = SampleHistory.way(plan, x, y);
        Studio studio = plan.studio();
        Camera camera = studio.camera();
        if (history == null || !camera.shutter().hasOpeningTime()) {
            return Double.NaN;
        }
        if (history.end() == null || history.end().frame() == Frame.CAMERA) {
            return 0;
        }
        SampleHistory.Encounter first = history.mainHits().stream()
                .filter(hit -> hit.frame() == Frame.SCENE)
                .findFirst()
                .orElseThrow();
        Vector2dc from = position(studio, -camera.exposureTime() / 2, first);
        Vector2dc to = position(studio, camera.exposureTime() / 2, first);
        return first.rest().velocity() != null || from == null || to == null ? Double.NaN : from.distance(to);
    }

    private static Vector2dc position(Studio studio, double later, SampleHistory.Encounter hit) {
        Camera camera = studio.camera();
        Shutter shutter = camera.shutter().openedAt(camera.shutter().openingTime() + later);
        return Projection.of(studio.withCamera(camera.withShutter(shutter)))
                .position(
                        new FrameAppearance(studio, hit.rest().motion()),
                        hit.rest().event().position());
    }
}
