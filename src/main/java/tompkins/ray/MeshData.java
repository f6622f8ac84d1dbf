package tompkins.ray;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;

/**
 * Triangles that share corners, as numbers, with the file that they came from. Immutable: the arrays are handed over
 * and must not be changed afterwards.
 */
public final class MeshData implements FileContent {

    /** An octahedron of radius 1 around the origin, for descriptions that still need a mesh. */
    public static final MeshData OCTAHEDRON = new MeshData(
            "",
            new double[] {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
            new int[] {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5},
            MeshDetail.NONE,
            new byte[0]);

    private final String name;
    private final double[] coordinates;
    private final int[] corners;
    private final MeshDetail detail;
    private final byte[] file;

    /** As far as somebody asked; else null. */
    private Boolean closed;

    /**
     * Triangles.
     *
     * @param name the file's name, as the scene file writes it
     * @param coordinates x, y and z of each vertex
     * @param corners three numbers of vertices, counted from 0, for each triangle
     * @param detail what as many triangles have besides their corners, or none of them
     * @param file the bytes of the file, or none if there are too many to keep
     * @throws IllegalArgumentException if an array does not come in threes, or a triangle names a vertex that is not
     *     there
     */
    public MeshData(String name, double[] coordinates, int[] corners, MeshDetail detail, byte[] file) {
        if (coordinates.length % 3 != 0 || corners.length % 3 != 0) {
            throw new IllegalArgumentException(name + ": " + coordinates.length + " coordinates and " + corners.length
                    + " corners do not come in threes");
        }
        for (int corner : corners) {
            if (corner < 0 || corner >= coordinates.length / 3) {
                throw new IllegalArgumentException(name + ": there is no vertex " + corner);
            }
        }
        this.name = name;
        this.coordinates = coordinates;
        this.corners = corners;
        this.detail = detail;
        this.file = file;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public byte[] file() {
        return file.clone();
    }

    @Override
    public int length() {
        return file.length;
    }

    /** What the triangles have besides their corners. */
    public MeshDetail detail() {
        return detail;
    }

    /** Number of triangles. */
    public int triangles() {
        return corners.length / 3;
    }

    /**
     * A coordinate of a corner of a triangle.
     *
     * @param triangle number of the triangle, from 0
     * @param corner number of its corner: 0, 1 or 2
     * @param axis 0 for x, 1 for y, 2 for z
     */
    public double coordinate(int triangle, int corner, int axis) {
        return coordinates[3 * corners[3 * triangle + corner] + axis];
    }

    /** Whether it has an inside: each edge joins two triangles. */
    public boolean isClosed() {
        if (closed == null) {
            Set<Long> open = new HashSet<>();
            for (int i = 0; i < corners.length; i++) {
                int next = i % 3 == 2 ? i - 2 : i + 1;
                long edge = (long) Math.min(corners[i], corners[next]) << Integer.SIZE
                        | Math.max(corners[i], corners[next]);
                if (!open.add(edge)) {
                    open.remove(edge);
                }
            }
            closed = open.isEmpty();
        }
        return closed;
    }

    /** The largest size of a coordinate of a vertex; 0 without vertices. */
    public double largestCoordinate() {
        double largest = 0;
        for (double coordinate : coordinates) {
            largest = Math.max(largest, Math.abs(coordinate));
        }
        return largest;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof MeshData mesh
                && name.equals(mesh.name)
                && Arrays.equals(corners, mesh.corners)
                && Arrays.equals(coordinates, mesh.coordinates)
                && detail.equals(mesh.detail);
    }

    @Override
    public int hashCode() {
        return name.hashCode() * 31 + corners.length;
    }

    @Override
    public String toString() {
        return name + " (" + triangles() + " triangles)";
    }
}
