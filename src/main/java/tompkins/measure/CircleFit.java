package tompkins.measure;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The circle of directions that fits some directions best, such as points on the outline of a sphere. It is exact for
 * spheres at any speed and off the axis, which a circle fitted in pixels is not: directions on a circle lie in a plane,
 * whose normal is the eigenvector of the smallest eigenvalue of their covariance.
 *
 * @param circle the circle; its axis is a unit vector
 * @param residual root of the mean square of the angles by which the directions miss it, in radians
 */
public record CircleFit(LookCone circle, double residual) {

    /**
     * Fits a circle to unit directions.
     *
     * @throws ArithmeticException if there are fewer than three, or they do not determine a circle
     */
    public static CircleFit of(List<? extends Vector3dc> directions) {
        if (directions.size() < 3) {
            throw new ArithmeticException("a circle needs 3 points or more, not " + directions.size());
        }
        Vector3d mean = new Vector3d();
        directions.forEach(mean::add);
        mean.div(directions.size());
        Scatter scatter = Scatter.about(mean, directions);
        if (!(scatter.middleSpread() > 1e-9 * scatter.largestSpread())) {
            throw new ArithmeticException("the points of a circle must not coincide");
        }
        Vector3d axis = scatter.thinnest();
        double cosine = axis.dot(mean);
        if (cosine < 0) {
            axis.negate();
            cosine = -cosine;
        }
        // the length of the part across the axis keeps the digits of small circles
        double across = 0;
        for (Vector3dc direction : directions) {
            across += axis.cross(direction, new Vector3d()).length() / directions.size();
        }
        double halfAngle = Math.atan2(across, cosine);
        double squares = 0;
        for (Vector3dc direction : directions) {
            double miss = Angles.between(axis, direction) - halfAngle;
            squares += miss * miss;
        }
        return new CircleFit(LookCone.around(axis, halfAngle), Math.sqrt(squares / directions.size()));
    }
}
