package tompkins.io;

import earcut4j.Earcut;
import java.util.Arrays;
import org.joml.Vector3d;

/**
 * Cuts faces into triangles. Seen from its first corner most faces are a fan, which takes a time that grows with their
 * corners. The others are laid flat, along their mean normal, and their ears are clipped by a library. A face that
 * crosses itself has no triangles that cover it, and is not cut; one that touches itself may not be, either.
 */
final class FaceTriangulation {

    /** The share of the area of a face that may be wrong; rounding alone gives less. */
    private static final double TOLERANCE = 1e-12;

    /** The most corners of a face that is no fan: clipping ears may take a time that grows with their square. */
    static final int MOST_CORNERS = 10_000;

    /** The share of the area that may be missed: far more than by rounding, far less than if something is wrong. */
    private static final double COVERED = 1e-9;

    private final double[] vertices;
    private int[] triangles;
    private int count;

    /**
     * No triangles yet.
     *
     * @param vertices x, y and z of each vertex
     * @param expected the expected number of triangles
     */
    FaceTriangulation(double[] vertices, int expected) {
        this.vertices = vertices;
        this.triangles = new int[3 * expected];
    }

    /** The number of triangles. */
    int count() {
        return count / 3;
    }

    /** Three corners for each triangle, as their indices in the array from which they came. */
    int[] triangles() {
        return count == triangles.length ? triangles : Arrays.copyOf(triangles, count);
    }

    /**
     * Cuts the face whose corners are in a part of an array.
     *
     * @return false if that is not possible: it crosses or touches itself, or has dents and too many corners
     */
    boolean add(int[] corners, int from, int to) {
        int size = to - from;
        if (size > 3) {
            Vector3d[] positions = positions(corners, from, to);
            Vector3d normal = normal(positions);
            if (!isFan(positions, normal)) {
                // without a normal as much of it runs clockwise as does not
                return size <= MOST_CORNERS && normal.lengthSquared() > 0 && addConcave(from, flat(positions, normal));
            }
        }
        for (int i = 2; i < size; i++) {
            addTriangle(from, from + i - 1, from + i);
        }
        return true;
    }

    private void addTriangle(int first, int second, int third) {
        if (count + 3 > triangles.length) {
            triangles = Arrays.copyOf(triangles, 2 * triangles.length + 3);
        }
        triangles[count++] = first;
        triangles[count++] = second;
        triangles[count++] = third;
    }

    /** The corners seen from the first. */
    private Vector3d[] positions(int[] corners, int from, int to) {
        Vector3d[] positions = new Vector3d[to - from];
        for (int i = 0; i < positions.length; i++) {
            positions[i] = position(corners[from + i]).sub(position(corners[from]));
        }
        return positions;
    }

    private Vector3d position(int vertex) {
        return new Vector3d(vertices[3 * vertex], vertices[3 * vertex + 1], vertices[3 * vertex + 2]);
    }

    /** Twice the area of the face as a vector that points to where its corners run counter-clockwise. */
    private static Vector3d normal(Vector3d[] positions) {
        Vector3d sum = new Vector3d();
        Vector3d cross = new Vector3d();
        for (int i = 2; i < positions.length; i++) {
            sum.add(positions[i - 1].cross(positions[i], cross));
        }
        return sum;
    }

    /** Whether the triangles between the first corner and each side do not overlap. */
    private static boolean isFan(Vector3d[] positions, Vector3d normal) {
        double area = normal.length();
        double backwards = 0;
        Vector3d cross = new Vector3d();
        for (int i = 2; i < positions.length; i++) {
            positions[i - 1].cross(positions[i], cross);
            backwards += area == 0 ? cross.length() : Math.max(0, -cross.dot(normal) / area);
        }
        return backwards <= TOLERANCE * area;
    }

    /** x and y of each corner in a plane, so that they run counter-clockwise. */
    private static double[] flat(Vector3d[] positions, Vector3d normal) {
        Vector3d up = normal.normalize(new Vector3d());
        // with an axis along the longest side, the numbers of long thin faces are exact
        Vector3d right = new Vector3d();
        for (Vector3d position : positions) {
            if (position.lengthSquared() > right.lengthSquared()) {
                right.set(position);
            }
        }
        right.fma(-right.dot(up), up).normalize();
        Vector3d forward = up.cross(right, new Vector3d());
        double[] flat = new double[2 * positions.length];
        for (int i = 0; i < positions.length; i++) {
            flat[2 * i] = positions[i].dot(right);
            flat[2 * i + 1] = positions[i].dot(forward);
        }
        return flat;
    }

    private boolean addConcave(int from, double[] flat) {
        int[] cut = Earcut.earcut(flat).stream().mapToInt(Integer::intValue).toArray();
        if (!covers(cut, flat)) {
            return false;
        }
        for (int i = 0; i < cut.length; i += 3) {
            boolean swapped = area(flat, cut[i], cut[i + 1], cut[i + 2]) < 0;
            addTriangle(from + cut[i], from + cut[swapped ? i + 2 : i + 1], from + cut[swapped ? i + 1 : i + 2]);
        }
        return true;
    }

    /** Whether triangles together are as large as their face. */
    private static boolean covers(int[] cut, double[] flat) {
        double whole = 0;
        for (int i = 2; i < flat.length / 2; i++) {
            whole += area(flat, 0, i - 1, i);
        }
        double covered = 0;
        for (int i = 0; i < cut.length; i += 3) {
            covered += Math.abs(area(flat, cut[i], cut[i + 1], cut[i + 2]));
        }
        return Math.abs(covered - whole) <= COVERED * whole;
    }

    /** Twice the area of a triangle, positive if its corners run counter-clockwise. */
    private static double area(double[] flat, int first, int second, int third) {
        double x = flat[2 * first];
        double y = flat[2 * first + 1];
        return (flat[2 * second] - x) * (flat[2 * third + 1] - y) - (flat[2 * third] - x) * (flat[2 * second + 1] - y);
    }
}
