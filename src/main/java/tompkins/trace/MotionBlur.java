package tompkins.trace;

import java.util.stream.DoubleStream;
import org.joml.Vector3d;

/**
 * How far what is seen moves across the picture while the shutter is open. A point stays where it is in the scene; the
 * place in the picture at which it is seen follows from three neighbouring rays: one beside, one below and one a little
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
        return length(plan.width() / 2, plan.height() / 2);
    }

    /** The largest length of the blur in the corners of the picture, in pixels; NaN if none is known. */
    double inTheWorstCorner() {
        int right = plan.width() - 1;
        int bottom = plan.height() - 1;
        return DoubleStream.of(length(0, 0), length(right, 0), length(0, bottom), length(right, bottom))
                .filter(length -> !Double.isNaN(length))
                .max()
                .orElse(Double.NaN);
    }

    /**
     * The length of the blur of what is seen at the centre of a pixel through the centre of the lens: how far it moves
     * at the speed that it has in the middle of the exposure. 0 for the background and for what moves with the camera.
     */
    double length(int column, int row) {
        double x = column + 0.5;
        double y = row + 0.5;
        RayLife life = at(x, y, 0.5);
        if (life == null || plan.width() < 2 || plan.height() < 2) {
            return Double.NaN;
        }
        RayLife.Encounter seen = life.end();
        if (seen == null || seen.frame() == Frame.CAMERA) {
            return 0;
        }
        // the first thing in the scene: mirrors and glass bend what comes after it
        Vector3d point = new Vector3d(life.mainHits().stream()
                .filter(hit -> hit.frame() == Frame.SCENE)
                .findFirst()
                .orElse(seen)
                .event()
                .position());
        Vector3d here = miss(life, point);
        int across = column == 0 ? 1 : -1;
        int down = row == 0 ? 1 : -1;
        Vector3d perColumn = miss(at(x + across, y, 0.5), point).sub(here).mul(across);
        Vector3d perRow = miss(at(x, y + down, 0.5), point).sub(here).mul(down);
        Vector3d perExposure = miss(at(x, y, 0.5 + LATER), point).sub(here).div(LATER);
        // columns and rows that undo what the exposure does, by least squares
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

    private RayLife at(double x, double y, double moment) {
        return RayLife.of(plan, x, y, 0, 0, moment);
    }

    /** How far a ray passes by a point, at right angles to the ray; NaN if it does not come to the scene. */
    private static Vector3d miss(RayLife life, Vector3d point) {
        if (life == null || life.sceneStart() == null) {
            return new Vector3d(Double.NaN);
        }
        Vector3d towards = point.sub(life.sceneStart().position(), new Vector3d());
        return towards.sub(new Vector3d(life.sceneDirection()).mul(towards.dot(life.sceneDirection())));
    }
}
