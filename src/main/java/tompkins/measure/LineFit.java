package tompkins.measure;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The great circle that fits some directions best: what a lens shows as a straight line, for instance a straight edge
 * before a camera at rest. Its normal is the eigenvector of the smallest eigenvalue of the sum of all n nᵀ.
 *
 * @param normal unit vector across the plane of the great circle
 * @param residual root of the mean square of the angles by which the directions miss it, in radians
 * @param worst the largest of these angles, in radians
 */
public record LineFit(Vector3dc normal, double residual, double worst) {

    /**
     * Fits a great circle to unit directions.
     *
     * @throws ArithmeticException if there are fewer than two, or they coincide
     */
    public static LineFit of(List<? extends Vector3dc> directions) {
        if (directions.size() < 2) {
            throw new ArithmeticException("a line needs 2 points or more, not " + directions.size());
        }
        Scatter scatter = Scatter.about(new Vector3d(), directions);
        if (!(scatter.middleSpread() > 1e-15 * scatter.largestSpread())) {
            throw new ArithmeticException("the points of a line must not coincide");
        }
        Vector3d normal = scatter.thinnest();
        double squares = 0;
        double worst = 0;
        for (Vector3dc direction : directions) {
            double miss = Math.asin(Math.max(-1, Math.min(1, normal.dot(direction))));
            squares += miss * miss;
            worst = Math.max(worst, Math.abs(miss));
        }
        return new LineFit(normal, Math.sqrt(squares / directions.size()), worst);
    }
}
