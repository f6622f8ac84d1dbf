package tompkins.explain;

import org.joml.Vector3d;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.TransformationLaw;
import tompkins.studio.View;
import tompkins.trace.Frame;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/**
 * How far what is seen moves across the picture while the shutter is open. A point moves with its object; the place in
 * the picture at which it is seen follows from three neighbouring rays: one beside it, one below it and one a little
 * later. The line delays of a rolling shutter are in these rays, and so are windows before the lens.
 */
final class MotionBlur {

    /** A little later: a part of the exposure time. */
    private static final double LATER = 1.0 / 256;

    private final RenderPlan plan;

    MotionBlur(RenderPlan plan) {
        this.plan = plan;
    }

    /** The length of the blur in the middle of the picture, in pixels; NaN if it is not known. */
    double inTheMiddle() {
        return length((int) plan.middle().x(), (int) plan.middle().y());
    }

    /**
     * The length of the blur of what is seen at the centre of a pixel through the centre of the lens: how far it moves
     * at the speed that it has in the middle of the exposure. 0 for the background and for what moves with the camera.
     */
    double length(int column, int row) {
        double x = column + 0.5;
        double y = row + 0.5;
        SampleHistory history = at(x, y, 0.5);
        if (history == null || plan.width() < 2 || plan.height() < 2) {
            return Double.NaN;
        }
        SampleHistory.Encounter seen = history.end();
        if (seen == null || seen.frame() == Frame.CAMERA) {
            return 0;
        }
        // the first hit in the scene: mirrors and glass bend what comes after it
        SampleHistory.Encounter first = history.mainHits().stream()
                .filter(hit -> hit.frame() == Frame.SCENE)
                .findFirst()
                .orElse(seen);
        Vector3d velocity = velocity(first.rest().motion());
        Event point = first.event();
        Vector3d here = miss(history, point, velocity);
        int across = column == 0 ? 1 : -1;
        int down = row == 0 ? 1 : -1;
        Vector3d perColumn =
                miss(at(x + across, y, 0.5), point, velocity).sub(here).mul(across);
        Vector3d perRow = miss(at(x, y + down, 0.5), point, velocity).sub(here).mul(down);
        Vector3d perExposure =
                miss(at(x, y, 0.5 + LATER), point, velocity).sub(here).div(LATER);
        // columns and rows that undo the effect of the exposure, by least squares
        double columns = perColumn.lengthSquared();
        double rows = perRow.lengthSquared();
        double mixed = perColumn.dot(perRow);
        double determinant = columns * rows - mixed * mixed;
        double ofColumns = perColumn.dot(perExposure);
        double ofRows = perRow.dot(perExposure);
        return Math.hypot(
                (rows * ofColumns - mixed * ofRows) / determinant,
                (columns * ofRows - mixed * ofColumns) / determinant);
    }

    private SampleHistory at(double x, double y, double moment) {
        return SampleHistory.way(plan, x, y, 0, 0, moment);
    }

    /** The velocity in the scene of what rests in a frame; NaN where light is not that of relativity. */
    private Vector3d velocity(FrameMotion motion) {
        if (motion == null) {
            return new Vector3d();
        }
        boolean ordinaryLight = plan.studio().transformation() == TransformationLaw.LORENTZ
                && plan.studio().view() != View.MEASURED;
        return ordinaryLight ? new Vector3d(motion.proper()).div(motion.gamma()) : new Vector3d(Double.NaN);
    }

    /**
     * How far a ray, followed backwards with the speed of light, passes by a point that was at an event and has a
     * velocity; NaN if the ray does not come to the scene.
     */
    private static Vector3d miss(SampleHistory history, Event event, Vector3d velocity) {
        if (history == null || history.sceneStart() == null) {
            return new Vector3d(Double.NaN);
        }
        Event start = history.sceneStart();
        Vector3d towards = new Vector3d(velocity)
                .mul(start.time() - event.time())
                .add(event.position())
                .sub(start.position());
        Vector3d approach = new Vector3d(history.sceneDirection()).add(velocity);
        return towards.sub(new Vector3d(approach).mul(towards.dot(approach) / approach.lengthSquared()));
    }
}
