package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/** Several rays around one, which show what becomes of a bundle of light. */
public final class RayCone {

    /** The distance of the rays of a pinhole from the one in their middle, in heights of the picture. */
    private static final double OPENING = 0.05;

    private RayCone() {}

    /**
     * Follows rays evenly around that of a point of the picture: with a wide aperture those of the point itself,
     * through the edge of the lens; else those through a circle around the point. Rays that never cross the shutter are
     * left out.
     *
     * @param x place in the picture in pixels
     * @param y place in the picture in pixels
     * @param count the number of rays
     * @param moment the part of the exposure time that has passed, from 0 to 1; the same for all
     */
    public static List<SampleHistory> around(RenderPlan plan, double x, double y, int count, double moment) {
        boolean throughEdge = plan.studio().camera().hasWideAperture();
        double opening = throughEdge ? 0 : OPENING * plan.height();
        double aperture = throughEdge ? 1 : 0;
        List<SampleHistory> rays = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * i / count;
            double right = Math.cos(angle);
            double up = Math.sin(angle);
            SampleHistory ray = SampleHistory.of(
                    plan, x + opening * right, y - opening * up, aperture * right, aperture * up, moment);
            if (ray != null) {
                rays.add(ray);
            }
        }
        return rays;
    }
}
