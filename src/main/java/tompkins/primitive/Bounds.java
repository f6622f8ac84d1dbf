package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** A box along the axes that holds a primitive. */
public record Bounds(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {

    /** Widening against rounding, relative to the largest coordinate. */
    private static final double MARGIN = 1e-14;

    /** The box around points. */
    public static Bounds around(Vector3dc... points) {
        Vector3d least = new Vector3d(points[0]);
        Vector3d most = new Vector3d(points[0]);
        for (Vector3dc point : points) {
            least.min(point);
            most.max(point);
        }
        return new Bounds(least.x, least.y, least.z, most.x, most.y, most.z);
    }

    /** The smallest box that holds this one and another. */
    public Bounds with(Bounds other) {
        return new Bounds(
                Math.min(minX, other.minX),
                Math.min(minY, other.minY),
                Math.min(minZ, other.minZ),
                Math.max(maxX, other.maxX),
                Math.max(maxY, other.maxY),
                Math.max(maxZ, other.maxZ));
    }

    /** Its eight corners. */
    public Vector3d[] corners() {
        Vector3d[] corners = new Vector3d[8];
        for (int i = 0; i < corners.length; i++) {
            corners[i] =
                    new Vector3d((i & 1) == 0 ? minX : maxX, (i & 2) == 0 ? minY : maxY, (i & 4) == 0 ? minZ : maxZ);
        }
        return corners;
    }

    /** The same box, moved. */
    public Bounds moved(Vector3dc way) {
        return new Bounds(
                minX + way.x(), minY + way.y(), minZ + way.z(), maxX + way.x(), maxY + way.y(), maxZ + way.z());
    }

    /** This box, widened so that rounding in a ray's arithmetic cannot lose what touches its sides. */
    public Bounds widened() {
        double margin = farthest() * MARGIN;
        return new Bounds(minX - margin, minY - margin, minZ - margin, maxX + margin, maxY + margin, maxZ + margin);
    }

    /** The largest size of a coordinate. */
    public double farthest() {
        double x = Math.max(Math.abs(minX), Math.abs(maxX));
        double y = Math.max(Math.abs(minY), Math.abs(maxY));
        double z = Math.max(Math.abs(minZ), Math.abs(maxZ));
        return Math.max(x, Math.max(y, z));
    }

    /** Half the distance between opposite corners. */
    public double halfDiagonal() {
        double x = maxX - minX;
        double y = maxY - minY;
        double z = maxZ - minZ;
        return Math.sqrt(x * x + y * y + z * z) / 2;
    }

    /** Half the area of the sides. */
    public double halfArea() {
        double x = maxX - minX;
        double y = maxY - minY;
        double z = maxZ - minZ;
        return x * y + y * z + z * x;
    }

    /** Distance of a point from the box; 0 inside. */
    public double distance(Vector3dc point) {
        double x = Math.max(0, Math.max(minX - point.x(), point.x() - maxX));
        double y = Math.max(0, Math.max(minY - point.y(), point.y() - maxY));
        double z = Math.max(0, Math.max(minZ - point.z(), point.z() - maxZ));
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** The centre. */
    public Vector3d centre() {
        return new Vector3d((minX + maxX) / 2, (minY + maxY) / 2, (minZ + maxZ) / 2);
    }
}
