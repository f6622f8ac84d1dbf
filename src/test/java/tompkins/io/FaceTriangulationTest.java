package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.CsvSource;

/** Areas against closed formulas; triangles that lay on each other, or outside their face, would make them larger. */
class FaceTriangulationTest {

    /** Corners in a plane, in both orders and with each as the first, in 10 planes in space. */
    @ParameterizedTest
    @CsvFileSource(resources = "faces.csv")
    void facesHaveTheirAreaInAnyPlane(String name, double area, String numbers) {
        double[] flat = Arrays.stream(numbers.split(" "))
                .mapToDouble(Double::parseDouble)
                .toArray();
        Random random = new Random(7);
        int size = flat.length / 2;
        for (int plane = 0; plane < 10; plane++) {
            double[] vertices = inSpace(flat, plane == 0 ? new Matrix3d() : rotation(random));
            int first = random.nextInt(size);
            int step = plane % 2 == 0 ? 1 : size - 1;
            int[] corners =
                    IntStream.range(0, size).map(i -> (first + i * step) % size).toArray();

            double[] areas = areas(vertices, corners, normal(vertices, corners));

            assertThat(areas[0]).as("sum of sizes").isCloseTo(area, within(1e-9 * area));
            assertThat(areas[1]).as("sum with signs").isCloseTo(area, within(1e-9 * area));
        }
    }

    /** A face with any distance from its middle to its corners, seen from the middle in the order of their angles. */
    @RepeatedTest(200)
    void facesWithDeepDentsHaveTheirArea(RepetitionInfo repetition) {
        Random random = new Random(repetition.getCurrentRepetition());
        int size = 4 + random.nextInt(40);
        double[] flat = new double[2 * size];
        for (int i = 0; i < size; i++) {
            double angle = 2 * Math.PI * (i + 0.9 * random.nextDouble()) / size;
            double distance = Math.pow(10, -3 * random.nextDouble());
            flat[2 * i] = distance * Math.cos(angle);
            flat[2 * i + 1] = distance * Math.sin(angle);
        }
        double[] vertices = inSpace(flat, rotation(random));
        int[] corners = IntStream.range(0, size).toArray();

        double[] areas = areas(vertices, corners, normal(vertices, corners));

        assertThat(areas[0]).isCloseTo(shoelace(flat), within(1e-12));
        assertThat(areas[1]).isCloseTo(shoelace(flat), within(1e-12));
    }

    /** The face is bent along the line from (0, 0, 0) to (1, 1, 0): no plane holds it. */
    @Test
    void facesThatAreNotFlatKeepAllCorners() {
        double[] vertices = {0, 0, 0, 3, 0, 0.3, 1, 1, 0, 0, 3, 0.3};

        int[] triangles = triangles(vertices, new int[] {3, 0, 1, 2});

        assertThat(IntStream.range(0, 2)
                        .mapToObj(i -> IntStream.of(triangles)
                                .skip(3L * i)
                                .limit(3)
                                .sorted()
                                .boxed()
                                .toList()))
                .containsExactlyInAnyOrder(List.of(0, 1, 2), List.of(0, 2, 3));
    }

    @ParameterizedTest
    @CsvSource({"1, 1000000", "0.5, 10000", "0.9, 1002", "0.999999, 1002"})
    @Timeout(600)
    void largeFacesAreCutSoon(double inner, int size) {
        double[] flat = new double[2 * size];
        for (int i = 0; i < size; i++) {
            double angle = 2 * Math.PI * i / size;
            flat[2 * i] = (i % 2 == 0 ? 1 : inner) * Math.cos(angle);
            flat[2 * i + 1] = (i % 2 == 0 ? 1 : inner) * Math.sin(angle);
        }

        requireArea(size * inner * Math.sin(2 * Math.PI / size) / 2, flat, new Matrix3d());
    }

    /** All kinds of corners that a sweeping line can meet, in all directions; some stand one above the other. */
    @RepeatedTest(30)
    void largeFacesWithDeepDentsHaveTheirArea(RepetitionInfo repetition) {
        Random random = new Random(repetition.getCurrentRepetition());
        boolean isComb = repetition.getCurrentRepetition() % 2 == 0;
        int size = 1001 + random.nextInt(500);
        double[] flat = new double[2 * size];
        for (int i = 0; i < size; i++) {
            double angle = 2 * Math.PI * (i + 0.9 * random.nextDouble()) / size;
            double distance = Math.pow(10, -2 * random.nextDouble());
            // two rows of teeth, one row behind the other
            flat[2 * i] = isComb ? 0.5 * Math.min(i, size - 1 - i) : distance * Math.cos(angle);
            flat[2 * i + 1] = isComb
                    ? (i < size / 2 ? -2 + random.nextInt(2) : 2 + i % 2) + 1e-3 * i
                    : distance * Math.sin(angle);
        }
        double area = shoelace(flat);

        requireArea(area, flat, isComb ? new Matrix3d() : rotation(random));
    }

    @Test
    void whatCannotBeCutIsNot() {
        double[] crossed = {0, 0, 0, 2, 0, 0, 2, 2, 0, 3, 2, 0, 0.5, -1, 0};
        assertThat(new FaceTriangulation(crossed, 3).add(new int[] {0, 1, 2, 3, 4}, 0, 5))
                .isFalse();
        double[] bow = {-1, -1, 0, 1, 1, 0, 1, -1, 0, -1, 1, 0};
        assertThat(new FaceTriangulation(bow, 2).add(new int[] {0, 1, 2, 3}, 0, 4))
                .as("as large on both sides")
                .isFalse();
        int[] many = IntStream.range(0, 10_002).toArray();
        double[] comb = new double[3 * many.length];
        for (int i = 0; i < many.length; i++) {
            comb[3 * i] = i;
            comb[3 * i + 1] = i % 2;
        }
        comb[comb.length - 2] = 10_000;
        assertThat(new FaceTriangulation(comb, 1).add(many, 0, many.length)).isFalse();
    }

    private static void requireArea(double area, double[] flat, Matrix3d rotation) {
        double[] vertices = inSpace(flat, rotation);
        int[] corners = IntStream.range(0, flat.length / 2).toArray();

        double[] areas = areas(vertices, corners, normal(vertices, corners));

        assertThat(areas[0]).isCloseTo(area, within(1e-9 * area));
        assertThat(areas[1]).isCloseTo(area, within(1e-9 * area));
    }

    private static double[] inSpace(double[] flat, Matrix3d rotation) {
        double[] vertices = new double[flat.length / 2 * 3];
        for (int i = 0; i < flat.length / 2; i++) {
            Vector3d place = new Vector3d(flat[2 * i], flat[2 * i + 1], 0).mul(rotation);
            vertices[3 * i] = place.x;
            vertices[3 * i + 1] = place.y;
            vertices[3 * i + 2] = place.z;
        }
        return vertices;
    }

    private static Matrix3d rotation(Random random) {
        Vector3d axis = new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalize();
        return new Matrix3d().rotation(2 * Math.PI * random.nextDouble(), axis);
    }

    private static double shoelace(double[] flat) {
        double twice = 0;
        for (int i = 0; i < flat.length; i += 2) {
            int next = (i + 2) % flat.length;
            twice += flat[i] * flat[next + 1] - flat[next] * flat[i + 1];
        }
        return Math.abs(twice) / 2;
    }

    /** The direction in space to which the shoelace formula of the three planes of coordinates points. */
    private static Vector3d normal(double[] vertices, int[] corners) {
        Vector3d normal = new Vector3d();
        for (int i = 0; i < corners.length; i++) {
            Vector3d next = place(vertices, corners[(i + 1) % corners.length]);
            normal.add(place(vertices, corners[i]).cross(next));
        }
        double largest = Math.abs(normal.get(normal.maxComponent()));
        return normal.div(largest).normalize();
    }

    private static Vector3d place(double[] vertices, int vertex) {
        return new Vector3d(vertices[3 * vertex], vertices[3 * vertex + 1], vertices[3 * vertex + 2]);
    }

    /** The sum of the sizes of all triangles, and the sum of what they turn to a direction. */
    private static double[] areas(double[] vertices, int[] corners, Vector3d direction) {
        int[] triangles = triangles(vertices, corners);
        double sizes = 0;
        double signed = 0;
        for (int i = 0; i < triangles.length; i += 3) {
            Vector3d first = place(vertices, triangles[i]);
            Vector3d cross = place(vertices, triangles[i + 1])
                    .sub(first)
                    .cross(place(vertices, triangles[i + 2]).sub(first));
            double along = cross.dot(direction) / 2;
            sizes += Math.abs(along);
            signed += along;
        }
        return new double[] {sizes, signed};
    }

    private static int[] triangles(double[] vertices, int[] corners) {
        FaceTriangulation triangulation = new FaceTriangulation(vertices, corners.length - 2);
        triangulation.add(corners, 0, corners.length);
        return IntStream.of(triangulation.triangles())
                .map(place -> corners[place])
                .toArray();
    }
}
