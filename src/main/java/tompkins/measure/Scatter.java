package tompkins.measure;

import java.util.List;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.EigenDecompositionSymmetric;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** How vectors scatter about a point, along three perpendicular axes. */
final class Scatter {

    /** The axes; their eigenvalues are in falling order. */
    private final EigenDecompositionSymmetric axes;

    private Scatter(EigenDecompositionSymmetric axes) {
        this.axes = axes;
    }

    static Scatter about(Vector3dc point, List<? extends Vector3dc> vectors) {
        double[][] sums = new double[3][3];
        for (Vector3dc vector : vectors) {
            Vector3d difference = vector.sub(point, new Vector3d());
            for (int row = 0; row < 3; row++) {
                for (int column = 0; column < 3; column++) {
                    sums[row][column] += difference.get(row) * difference.get(column);
                }
            }
        }
        return new Scatter(new EigenDecompositionSymmetric(new Array2DRowRealMatrix(sums, false)));
    }

    double largestSpread() {
        return axes.getEigenvalue(0);
    }

    double middleSpread() {
        return axes.getEigenvalue(1);
    }

    /** The unit vector along which they scatter least. */
    Vector3d thinnest() {
        double[] vector = axes.getEigenvector(2).toArray();
        return new Vector3d(vector[0], vector[1], vector[2]).normalize();
    }
}
