package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix3d;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Velocity;

/**
 * What moves past a camera, in pictures. Here the camera is the one that stands still: the scene moves with -beta, is
 * contracted along its motion, and is seen where it was when the light left.
 */
class MovingObjectsTest {

    /** Where in the camera frame, at its time 0, a point is that rests in the scene: contracted along beta. */
    private static Vector3d atCameraTimeZero(Vector3dc scenePoint, Vector3dc beta) {
        double gamma = 1 / Math.sqrt(1 - beta.lengthSquared());
        double along = scenePoint.dot(beta) / beta.lengthSquared();
        return new Vector3d(beta).mul(along * (1 / gamma - 1)).add(scenePoint);
    }

    /** The scene point that is at a place of the camera frame at a camera time. */
    private static Vector3d scenePoint(Vector3dc cameraPlace, double time, Vector3dc beta) {
        Vector3d atZero = new Vector3d(beta).mul(time).add(cameraPlace);
        double gamma = 1 / Math.sqrt(1 - beta.lengthSquared());
        double along = atZero.dot(beta) / beta.lengthSquared();
        return atZero.add(new Vector3d(beta).mul(along * (gamma - 1)));
    }

    /** Where a point r0 + v t is seen from the origin at time T: on the past light cone. */
    private static Vector3d apparent(Vector3dc r0, Vector3dc v, double time) {
        double gammaSquared = 1 / (1 - v.lengthSquared());
        double sum = time + r0.dot(v);
        double emission =
                gammaSquared * (sum - Math.sqrt(sum * sum - (time * time - r0.lengthSquared()) / gammaSquared));
        return new Vector3d(v).mul(emission).add(r0);
    }

    @ParameterizedTest
    @CsvSource({
        "0.9, 0, 0, 3, -2, 10, 0",
        "0.2, -0.1, 0.97, 3, -2, 40, 1",
        "0.2, -0.1, 0.97, -1, 1, 8, -3",
        "-0.6, 0.3, -0.2, 1, 5, 7, 2.5",
        "0, 0, 0.999, 0.5, 0.2, 50, 0"
    })
    void pointsAreSeenWhereTheyWereWhenTheLightLeft(
            double bx, double by, double bz, double x, double y, double z, double time) {
        Vector3d beta = new Vector3d(bx, by, bz);
        Vector3d point = new Vector3d(x, y, z);
        Vector3d seen = apparent(atCameraTimeZero(point, beta), beta.negate(new Vector3d()), time);
        SceneObject ball = new Sphere("ball", point, 1e-5 * seen.length(), Photograph.WHITE);
        Photograph photograph =
                Photograph.of(List.of(ball), Photograph.pinhole(seen, 0.02, time), Velocity.of(beta), 100, 100);
        Vector2d centroid = photograph.centroid(0);
        assertThat(centroid.distance(50, 50)).as("pixels of 3.5e-6 radians").isLessThan(1);
    }

    @Test
    void farCubeLooksTurned() {
        double speed = 0.8;
        double distance = 10_000;
        // the cube's sides as two luminous squares, seen at 90 degrees by the camera
        Vector3d corner = new Vector3d(-speed * distance, -0.5, 0.6 * distance);
        SceneObject front =
                new Parallelogram("front", corner, new Vector3d(-1, 0, 0), new Vector3d(0, 1, 0), Photograph.RED);
        SceneObject side =
                new Parallelogram("side", corner, new Vector3d(0, 0, 1), new Vector3d(0, 1, 0), Photograph.GREEN);
        double seenDistance = distance * 0.6;
        double degrees = Math.toDegrees(4 / seenDistance);
        Photograph photograph = Photograph.of(
                List.of(front, side),
                Photograph.pinhole(new Vector3d(0, 0, 1), degrees, 0),
                Velocity.of(speed, 0, 0),
                400,
                200);
        double pixelsOfALength = 100;
        assertThat(width(photograph, 0) / pixelsOfALength).isCloseTo(0.6, within(0.015));
        assertThat(width(photograph, 1) / pixelsOfALength).isCloseTo(speed, within(0.015));
        double turn = Math.toDegrees(Math.atan2(width(photograph, 1), width(photograph, 0)));
        assertThat(turn).isCloseTo(53.1301, within(0.5));
        assertThat(height(photograph) / pixelsOfALength).isCloseTo(1, within(0.015));
    }

    /** Lit columns in the middle row. */
    private static int width(Photograph photograph, int channel) {
        int width = 0;
        for (int column = 0; column < photograph.image().width(); column++) {
            width += photograph.isLit(column, photograph.image().height() / 2, channel) ? 1 : 0;
        }
        return width;
    }

    private static int height(Photograph photograph) {
        double[] range = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
        photograph.forEachLit(0, place -> {
            range[0] = Math.min(range[0], place.y);
            range[1] = Math.max(range[1], place.y);
        });
        return (int) (range[1] - range[0] + 1);
    }

    /** x^2 = A + B x + C y^2, fitted to the picture of a rod across the motion. */
    @ParameterizedTest
    @CsvSource({"0.6, 0", "0.8, 0.5", "0.3, 0.5", "0.85, 0.8"})
    void rodAcrossTheMotionIsAHyperbola(double speed, double time) {
        double gamma = 1 / Math.sqrt(1 - speed * speed);
        double distance = 2;
        SceneObject rod = new Parallelogram(
                "rod",
                new Vector3d(-0.01, -50, distance),
                new Vector3d(0.02, 0, 0),
                new Vector3d(0, 100, 0),
                Photograph.WHITE);
        Photograph photograph = Photograph.of(
                List.of(rod),
                Photograph.pinhole(new Vector3d(0, 0, 1), 125, time),
                Velocity.of(-speed, 0, 0),
                1200,
                1200);
        List<Vector2d> places = middleOfEachRow(photograph).stream()
                .map(photograph::cameraDirection)
                .map(d -> new Vector2d(d.x / d.z, d.y / d.z).mul(distance))
                .toList();
        assertThat(places).hasSizeGreaterThan(500);
        Matrix3d squares = new Matrix3d().zero();
        Vector3d sums = new Vector3d();
        for (Vector2d place : places) {
            Vector3d row = new Vector3d(1, place.x, place.y * place.y);
            squares.add(new Matrix3d(
                    row.x * row.x,
                    row.x * row.y,
                    row.x * row.z,
                    row.y * row.x,
                    row.y * row.y,
                    row.y * row.z,
                    row.z * row.x,
                    row.z * row.y,
                    row.z * row.z));
            sums.add(row.mul(place.x * place.x));
        }
        Vector3d fitted = squares.invert().transform(sums);
        // (x - b g^2 T)^2/(b g)^2 - y^2 = d^2 + b^2 g^2 T^2, multiplied out
        double square = speed * speed * gamma * gamma;
        assertThat(fitted.x).isCloseTo(square * (distance * distance - time * time), within(0.08 * square * 4));
        assertThat(fitted.y).isCloseTo(2 * speed * gamma * gamma * time, within(0.08 * speed * gamma * gamma));
        assertThat(fitted.z).isCloseTo(square, within(0.08 * square));
        assertThat(places).allSatisfy(place -> {
            double left = Math.pow(place.x - speed * gamma * gamma * time, 2);
            double right = square * (place.y * place.y + distance * distance + square * time * time);
            assertThat(Math.sqrt(left)).isCloseTo(Math.sqrt(right), within(0.01));
        });
    }

    private static List<Vector2d> middleOfEachRow(Photograph photograph) {
        List<Vector2d> middles = new ArrayList<>();
        for (int row = 0; row < photograph.image().height(); row++) {
            double sum = 0;
            int count = 0;
            for (int column = 0; column < photograph.image().width(); column++) {
                if (photograph.isLit(column, row, 0)) {
                    sum += column + 0.5;
                    count++;
                }
            }
            if (count > 0 && !photograph.isLit(0, row, 0)) {
                middles.add(new Vector2d(sum / count, row + 0.5));
            }
        }
        return middles;
    }

    @Test
    void rodsAlongTheMotionStayStraight() {
        SceneObject rod = new Cylinder(
                "rod", new Vector3d(-50, 0.7, 2), new Vector3d(50, 0.7, 2), 0.005, false, Photograph.WHITE);
        Photograph photograph = Photograph.of(
                List.of(rod), Photograph.pinhole(new Vector3d(0, 0, 1), 100, 0.4), Velocity.of(0.9, 0, 0), 600, 600);
        List<Double> rows = new ArrayList<>();
        photograph.forEachLit(0, place -> rows.add(place.y));
        assertThat(rows).hasSizeGreaterThan(590);
        double expected = 300 - 0.35 / Math.tan(Math.toRadians(50)) * 300;
        assertThat(rows).allSatisfy(row -> assertThat(row).isCloseTo(expected, within(1.5)));
    }

    /**
     * A rod that hangs a little beside the line of motion: the height of its ends in the picture tells their distance.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.6, -0.6, 0.9})
    void rodOnTheLineOfMotionIsLongAheadAndShortBehind(double speed) {
        double side = 0.01;
        Vector3d beta = new Vector3d(0, 0, speed);
        double near = 10;
        double length = 4;
        // light of the near end comes from a place at distance `near`, at camera time -near
        Vector3d first = scenePoint(new Vector3d(side, 0, near), -near, beta);
        SceneObject rod = new Parallelogram(
                "rod",
                new Vector3d(first).sub(0, 1e-4, 0),
                new Vector3d(0, 0, length),
                new Vector3d(0, 2e-4, 0),
                Photograph.WHITE);
        double fieldOfView = 2 * Math.toDegrees(1.2 * side / near);
        Photograph photograph = Photograph.of(
                List.of(rod),
                Photograph.pinhole(beta.z > 0 ? beta : beta.negate(new Vector3d()), fieldOfView, 0),
                Velocity.of(beta),
                8000,
                31);
        double[] angles = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
        photograph.forEachLit(0, place -> {
            Vector3d direction = photograph.cameraDirection(place);
            angles[0] = Math.min(angles[0], direction.x / direction.z);
            angles[1] = Math.max(angles[1], direction.x / direction.z);
        });
        double apparentLength = side / angles[0] - side / angles[1];
        assertThat(side / angles[1]).isCloseTo(near, within(0.01));
        assertThat(apparentLength).isCloseTo(length * Math.sqrt((1 + speed) / (1 - speed)), within(0.1));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.6, 0.9, 0.99})
    void rodWithBothEndsEquallyFarIsContracted(double speed) {
        double contracted = 2 * Math.sqrt(1 - speed * speed);
        double distance = 3;
        SceneObject rod = new Parallelogram(
                "rod",
                new Vector3d(-1, -0.02, distance),
                new Vector3d(2, 0, 0),
                new Vector3d(0, 0.04, 0),
                Photograph.WHITE);
        // the light leaves both ends at camera time 0, when the rod's middle passes
        double time = Math.hypot(distance, contracted / 2);
        Photograph photograph = Photograph.of(
                List.of(rod), Photograph.pinhole(new Vector3d(0, 0, 1), 40, time), Velocity.of(speed, 0, 0), 2000, 11);
        double pixel = 2 * Math.tan(Math.toRadians(20)) / 2000 * distance;
        assertThat(width(photograph, 0) * pixel).isCloseTo(contracted, within(2 * pixel));
    }

    @ParameterizedTest
    @CsvSource({"0.8, 36.86989764584402, 1.33333", "0.95, 20, 3.02836"})
    void thingsSeemToMoveFasterThanLight(double speed, double degrees, double expected) {
        double distance = 1e5;
        double angle = Math.toRadians(degrees);
        // towards the camera, at an angle from the line of sight
        Vector3d beta = new Vector3d(speed * Math.sin(angle), 0, -speed * Math.cos(angle)).negate();
        Vector3d start = scenePoint(new Vector3d(0, 0, distance), -distance, beta);
        SceneObject ball = new Sphere("ball", start, 0.05, Photograph.WHITE);
        double[] seen = new double[2];
        for (int picture = 0; picture < 2; picture++) {
            Photograph photograph = Photograph.of(
                    List.of(ball),
                    Photograph.pinhole(new Vector3d(0, 0, 1), Math.toDegrees(16 / distance), picture * 2.0),
                    Velocity.of(beta),
                    1600,
                    40);
            seen[picture] = photograph.centroid(0).x;
        }
        assertThat((seen[1] - seen[0]) * 0.01 / 2).isCloseTo(expected, within(0.015));
    }
}
