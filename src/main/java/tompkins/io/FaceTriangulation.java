package tompkins.io;

import earcut4j.Earcut;
import java.util.Arrays;
import org.joml.Vector3d;

/**
 * Cuts faces into triangles. Seen from its first corner most faces are a fan, which takes a time that grows with their
 * corners. The others are laid flat, along their mean normal, and their ears are clipped by a library; large ones are
 * swept, which takes less time but needs a face that does not touch or cross itself.
 */
final class FaceTriangulation {

    /** The share of the area of a face that may be wrong; rounding alone gives less. */
    private static final double TOLERANCE = 1e-12;

    /** Faces of more corners are swept first: clipping ears may take a time that grows with their square. */
    private static final int MOST_FOR_EARS = 1000;

    /** For faces with more corners, only the first corner is tried as the first one. */
    private static final int MOST_TO_TRY = 64;

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

    /** Three vertices for each triangle. */
    int[] triangles() {
        return count == triangles.length ? triangles : Arrays.copyOf(triangles, count);
    }

    /** Cuts the face whose corners are in a part of an array. */
    void add(int[] corners, int from, int to) {
        int size = to - from;
        if (size > 3) {
            Vector3d[] places = places(corners, from, to);
            Vector3d normal = normal(places);
            if (normal.lengthSquared() > 0 && !isFan(places, normal)) {
                addConcave(corners, from, flat(places, normal));
                return;
            }
        }
        for (int i = 2; i < size; i++) {
            addTriangle(corners[from], corners[from + i - 1], corners[from + i]);
        }
    }

    private void addTriangle(int first, int second, int third) {
        if (count + 3 > triangles.length) {
            triangles = Arrays.copyOf(triangles, 2 * triangles.length + 3);
        }
        triangles[count++] = first;
        triangles[count++] = second;
        triangles[count++] = third;
    }

    /** The corners seen from the first, in a unit that makes the largest coordinate 1, so that no product overflows. */
    private Vector3d[] places(int[] corners, int from, int to) {
        Vector3d[] places = new Vector3d[to - from];
        double size = 0;
        for (int i = 0; i < places.length; i++) {
            // halves: the difference of two numbers may be larger than any number
            places[i] = half(corners[from + i]).sub(half(corners[from]));
            size = Math.max(size, largest(places[i]));
        }
        if (size > 0) {
            for (Vector3d place : places) {
                place.set(place.x / size, place.y / size, place.z / size);
            }
        }
        return places;
    }

    private Vector3d half(int vertex) {
        return new Vector3d(vertices[3 * vertex], vertices[3 * vertex + 1], vertices[3 * vertex + 2]).mul(0.5);
    }

    private static double largest(Vector3d vector) {
        return Math.abs(vector.get(vector.maxComponent()));
    }

    /** Twice the area of the face as a vector that points to where its corners run counter-clockwise. */
    private static Vector3d normal(Vector3d[] places) {
        Vector3d sum = new Vector3d();
        Vector3d cross = new Vector3d();
        for (int i = 2; i < places.length; i++) {
            sum.add(places[i - 1].cross(places[i], cross));
        }
        return sum;
    }

    /** Whether the triangles between the first corner and each side do not overlap. */
    private static boolean isFan(Vector3d[] places, Vector3d normal) {
        double area = normal.length();
        double backwards = 0;
        Vector3d cross = new Vector3d();
        for (int i = 2; i < places.length; i++) {
            backwards += Math.max(0, -places[i - 1].cross(places[i], cross).dot(normal) / area);
        }
        return backwards <= TOLERANCE * area;
    }

    /** x and y of each corner in a plane, so that they run counter-clockwise. */
    private static double[] flat(Vector3d[] places, Vector3d normal) {
        Vector3d up = normal.normalize(new Vector3d());
        // with an axis along the longest side, the numbers of long thin faces are exact
        Vector3d right = new Vector3d();
        for (Vector3d place : places) {
            if (place.lengthSquared() > right.lengthSquared()) {
                right.set(place);
            }
        }
        right.fma(-right.dot(up), up).normalize();
        Vector3d forward = up.cross(right, new Vector3d());
        double[] flat = new double[2 * places.length];
        for (int i = 0; i < places.length; i++) {
            flat[2 * i] = places[i].dot(right);
            flat[2 * i + 1] = places[i].dot(forward);
        }
        return flat;
    }

    private void addConcave(int[] corners, int from, double[] flat) {
        int[] cut = cut(flat);
        for (int i = 0; i < cut.length; i += 3) {
            boolean swapped = area(flat, cut[i], cut[i + 1], cut[i + 2]) < 0;
            addTriangle(
                    corners[from + cut[i]],
                    corners[from + cut[swapped ? i + 2 : i + 1]],
                    corners[from + cut[swapped ? i + 1 : i + 2]]);
        }
    }

    /**
     * The corners of triangles that cover a flat face; for a face that crosses itself, whatever the library gives. If a
     * face touches itself, the library may need to begin at another corner.
     */
    private static int[] cut(double[] flat) {
        int size = flat.length / 2;
        if (size > MOST_FOR_EARS) {
            int[] swept = swept(flat);
            if (covers(swept, flat)) {
                return swept;
            }
        }
        int[] first = ears(flat, 0);
        int[] cut = first;
        for (int start = 1; start < size && size <= MOST_TO_TRY && !covers(cut, flat); start++) {
            cut = ears(flat, start);
        }
        return covers(cut, flat) ? cut : first;
    }

    private static int[] swept(double[] flat) {
        int size = flat.length / 2;
        double[] distinct = new double[flat.length];
        int[] corners = new int[size];
        int count = 0;
        for (int i = 0; i < size; i++) {
            int before = i == 0 ? size - 1 : i - 1;
            if (flat[2 * i] != flat[2 * before] || flat[2 * i + 1] != flat[2 * before + 1]) {
                distinct[2 * count] = flat[2 * i];
                distinct[2 * count + 1] = flat[2 * i + 1];
                corners[count++] = i;
            }
        }
        return Arrays.stream(SweepTriangulation.triangles(Arrays.copyOf(distinct, 2 * count)))
                .map(corner -> corners[corner])
                .toArray();
    }

    private static int[] ears(double[] flat, int start) {
        double[] turned = new double[flat.length];
        System.arraycopy(flat, 2 * start, turned, 0, flat.length - 2 * start);
        System.arraycopy(flat, 0, turned, flat.length - 2 * start, 2 * start);
        return Earcut.earcut(turned).stream()
                .mapToInt(corner -> (corner + start) % (flat.length / 2))
                .toArray();
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
