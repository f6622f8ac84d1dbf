package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleBiFunction;
import java.util.function.ToDoubleFunction;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.EigenDecompositionSymmetric;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;
import org.hipparchus.linear.RealVector;
import org.hipparchus.linear.SingularValueDecomposition;
import org.joml.Vector2d;
import org.joml.Vector2dc;

/**
 * The conic that fits some points of a plane best: the sum of the squared distances, each to first order (Sampson
 * 1982), is least. Ellipses and hyperbolas are treated alike, so that the points say which of them it is. The start is
 * the fit of Taubin (1991).
 *
 * @param conic the conic
 * @param residual root of the mean square of the distances of the points from it
 * @param neighbours conics on both sides that the points allow as well, in five independent directions
 */
public record ConicFit(Conic conic, double residual, List<Neighbours> neighbours) {

    /** The fewest points that tell a conic. */
    public static final int FEWEST = 5;

    private static final int MOST_STEPS = 50;
    private static final int MOST_HALVINGS = 20;
    private static final int NUMBERS = 6;

    /** What is less than this part of a size is rounding. */
    private static final double SMALL = 1e-7;

    /** What kind of curve a conic is. */
    public enum Kind {
        /** Closed; a circle, too. */
        ELLIPSE,
        /** Or so near to one that the points do not tell. */
        PARABOLA,
        /** Open, with asymptotes. */
        HYPERBOLA;

        /** Its name in lower case. */
        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /** Two conics, as far from the best one as the uncertainty of the points allows. */
    public record Neighbours(Conic before, Conic after) {}

    /** The kind of the conic; a parabola if its eccentricity is 1 within the uncertainty. */
    public Kind kind() {
        double beyond = conic.eccentricity() - 1;
        if (Math.abs(beyond) <= uncertainty(Conic::eccentricity)) {
            return Kind.PARABOLA;
        }
        return beyond < 0 ? Kind.ELLIPSE : Kind.HYPERBOLA;
    }

    /**
     * By how much a number of the conic is uncertain, since the positions of the points are; NaN if that is not known.
     */
    public double uncertainty(ToDoubleFunction<Conic> number) {
        return uncertainty((one, other) -> number.applyAsDouble(one) - number.applyAsDouble(other));
    }

    /** By how much the direction of the axis is uncertain, in radians: a right angle at most, since it has two ends. */
    public double axisUncertainty() {
        double together = uncertainty((one, other) ->
                Math.asin(Math.min(1, Math.abs(cross(one.towardsVertex(), other.towardsVertex())))));
        return Math.min(Math.PI / 2, together);
    }

    private static double cross(Vector2dc one, Vector2dc other) {
        return one.x() * other.y() - one.y() * other.x();
    }

    private double uncertainty(ToDoubleBiFunction<Conic, Conic> difference) {
        double squares = 0;
        for (Neighbours each : neighbours) {
            double most = Math.max(
                    Math.abs(difference.applyAsDouble(each.before, conic)),
                    Math.abs(difference.applyAsDouble(each.after, conic)));
            squares += most * most;
        }
        return Math.sqrt(squares);
    }

    /**
     * Fits a conic to points.
     *
     * @param pointUncertainty by how much each coordinate of a point is uncertain; where points scatter by more, that
     *     counts
     * @throws ArithmeticException if they are fewer than {@link #FEWEST}, or do not tell a conic
     */
    public static ConicFit of(List<? extends Vector2dc> points, double pointUncertainty) {
        if (points.size() < FEWEST) {
            throw new ArithmeticException("a conic needs " + FEWEST + " points or more, not " + points.size());
        }
        Vector2d middle = new Vector2d();
        points.forEach(middle::add);
        middle.div(points.size());
        double scale = 0;
        for (Vector2dc point : points) {
            scale = Math.max(scale, point.distance(middle));
        }
        if (scale == 0) {
            throw new ArithmeticException("the points of a conic must not coincide");
        }
        double unit = scale;
        List<Vector2d> near = points.stream()
                .map(point -> point.sub(middle, new Vector2d()).div(unit))
                .toList();
        Distances best = improved(near, new Distances(near, start(near)));
        double residual = best.values.getNorm() / Math.sqrt(points.size());
        List<Neighbours> neighbours =
                best.neighbours(Math.max(pointUncertainty / scale, best.scatter()), scale, middle);
        Conic conic = conic(best.numbers).scaled(scale, middle);
        requireConic(conic.semiLatusRectum() > 0 && conic.focus().isFinite());
        return new ConicFit(conic, scale * residual, neighbours);
    }

    private static Conic conic(RealVector of) {
        return Conic.of(of.getEntry(0), of.getEntry(1), of.getEntry(2), of.getEntry(3), of.getEntry(4), of.getEntry(5));
    }

    private static double[] powers(Vector2dc point) {
        double x = point.x();
        double y = point.y();
        return new double[] {x * x, x * y, y * y, x, y, 1};
    }

    private static double[] byX(Vector2dc point) {
        return new double[] {2 * point.x(), point.y(), 0, 1, 0, 0};
    }

    private static double[] byY(Vector2dc point) {
        return new double[] {0, point.x(), 2 * point.y(), 0, 1, 0};
    }

    /** The numbers for which the sum of squares of the equation is least, divided by that of its gradients. */
    private static RealVector start(List<? extends Vector2dc> points) {
        int last = NUMBERS - 1;
        RealVector mean = new ArrayRealVector(NUMBERS);
        for (Vector2dc point : points) {
            mean = mean.add(new ArrayRealVector(powers(point)).mapDivide(points.size()));
        }
        RealMatrix values = new Array2DRowRealMatrix(points.size(), last);
        RealMatrix gradients = new Array2DRowRealMatrix(last, last);
        for (int i = 0; i < points.size(); i++) {
            Vector2dc point = points.get(i);
            values.setRowVector(
                    i, new ArrayRealVector(powers(point)).subtract(mean).getSubVector(0, last));
            RealVector x = new ArrayRealVector(byX(point)).getSubVector(0, last);
            RealVector y = new ArrayRealVector(byY(point)).getSubVector(0, last);
            gradients = gradients.add(x.outerProduct(x)).add(y.outerProduct(y));
        }
        EigenDecompositionSymmetric slopes = new EigenDecompositionSymmetric(gradients);
        requireConic(slopes.getEigenvalue(last - 1) > SMALL * SMALL * slopes.getEigenvalue(0));
        RealMatrix back = MatrixUtils.inverse(slopes.getSquareRoot());
        SingularValueDecomposition parts = new SingularValueDecomposition(values.multiply(back));
        requireConic(parts.getSingularValues()[last - 2] > SMALL * parts.getSingularValues()[0]);
        RealVector first = back.operate(parts.getV().getColumnVector(last - 1));
        return first.append(-first.dotProduct(mean.getSubVector(0, last))).unitVector();
    }

    private static void requireConic(boolean isOne) {
        if (!isOne) {
            throw new ArithmeticException("the points of a conic must not lie on straight lines");
        }
    }

    /** Steps of Gauss and Newton, each halved until it helps. */
    private static Distances improved(List<? extends Vector2dc> points, Distances start) {
        Distances best = start;
        for (int step = 0; step < MOST_STEPS; step++) {
            RealVector way =
                    new SingularValueDecomposition(best.slopes).getSolver().solve(best.values);
            Distances next = null;
            for (int halving = 0; halving < MOST_HALVINGS && next == null; halving++) {
                Distances tried = new Distances(points, best.numbers.subtract(way));
                next = tried.values.getNorm() < best.values.getNorm() ? tried : null;
                way = way.mapMultiply(0.5);
            }
            if (next == null) {
                return best;
            }
            best = next;
        }
        return best;
    }

    /** The signed distances of points from the conic of six numbers, to first order, and how they change with these. */
    private static final class Distances {

        private final RealVector numbers;
        private final RealVector values;
        private final RealMatrix slopes;

        Distances(List<? extends Vector2dc> points, RealVector anyNumbers) {
            numbers = anyNumbers.unitVector();
            values = new ArrayRealVector(points.size());
            slopes = new Array2DRowRealMatrix(points.size(), NUMBERS);
            for (int i = 0; i < points.size(); i++) {
                RealVector power = new ArrayRealVector(powers(points.get(i)));
                RealVector byX = new ArrayRealVector(byX(points.get(i)));
                RealVector byY = new ArrayRealVector(byY(points.get(i)));
                double value = numbers.dotProduct(power);
                double x = numbers.dotProduct(byX);
                double y = numbers.dotProduct(byY);
                double gradient = Math.hypot(x, y);
                values.setEntry(i, value / gradient);
                slopes.setRowVector(
                        i,
                        power.mapDivide(gradient)
                                .combineToSelf(1, -value * x / (gradient * gradient * gradient), byX)
                                .combineToSelf(1, -value * y / (gradient * gradient * gradient), byY));
            }
        }

        /** By how much points are off, as far as more of them tell it than a conic needs. */
        double scatter() {
            int more = values.getDimension() - FEWEST;
            return more == 0 ? 0 : values.getNorm() / Math.sqrt(more);
        }

        List<Neighbours> neighbours(double pointUncertainty, double scale, Vector2dc origin) {
            SingularValueDecomposition parts = new SingularValueDecomposition(slopes);
            List<Neighbours> all = new ArrayList<>();
            for (int i = 0; i < FEWEST; i++) {
                RealVector way =
                        parts.getV().getColumnVector(i).mapMultiply(pointUncertainty / parts.getSingularValues()[i]);
                all.add(new Neighbours(
                        conic(numbers.subtract(way)).scaled(scale, origin),
                        conic(numbers.add(way)).scaled(scale, origin)));
            }
            return List.copyOf(all);
        }
    }
}
