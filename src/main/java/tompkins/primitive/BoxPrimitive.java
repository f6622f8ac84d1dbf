package tompkins.primitive;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.surface.Surface;

/**
 * A box in space, of any orientation. Its parts are its faces: 2 axis for the lower one, 2 axis + 1 for the upper one.
 */
public final class BoxPrimitive extends Primitive {

    private static final int NO_FACE = -1;

    private final Vector3d centre;

    // two opposite corners, because a point near a face of a large box would lose digits if measured from the centre
    private final Vector3d lowest;
    private final Vector3d highest;

    private final Vector3d[] axes;
    private final double[] half;

    // of each face; null if the surface asks for no coordinates
    private final FaceCoordinates[] faces;

    /** The box of an object between two opposite corners, before it is placed. */
    public BoxPrimitive(Described object, Surface surface, Vector3dc from, Vector3dc to, Placement placement) {
        super(object, surface);
        Vector3d size = to.sub(from, new Vector3d());
        centre = placement.point(from.add(size.x / 2, size.y / 2, size.z / 2, new Vector3d()));
        lowest = placement.point(from);
        highest = placement.point(to);
        axes = new Vector3d[] {
            placement.direction(new Vector3d(1, 0, 0)),
            placement.direction(new Vector3d(0, 1, 0)),
            placement.direction(new Vector3d(0, 0, 1))
        };
        half = new double[] {
            size.x / 2 * placement.scale(), size.y / 2 * placement.scale(), size.z / 2 * placement.scale()
        };
        faces = surface.usesCoordinates() ? faces(size, placement) : null;
    }

    private static FaceCoordinates[] faces(Vector3dc size, Placement placement) {
        FaceCoordinates[] faces = new FaceCoordinates[6];
        for (int face = 0; face < faces.length; face++) {
            int axis = face / 2;
            int upAxis = axis == 1 ? 2 : 1;
            int rightAxis = 3 - axis - upAxis;
            Vector3d outwards = new Vector3d().setComponent(axis, face % 2 == 0 ? -1 : 1);
            faces[face] = FaceCoordinates.across(outwards, size.get(rightAxis), size.get(upAxis), placement);
        }
        return faces;
    }

    /** A ray that starts on a face meets the box again only if it goes inwards, and then on another face. */
    @Override
    public double distance(Ray ray, double limit) {
        int start = ray.boundary == this ? ray.part : NO_FACE;
        double enter = Double.NEGATIVE_INFINITY;
        double leave = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double slope = along(axis, ray.dx, ray.dy, ray.dz);
            double toLowest = along(axis, lowest.x - ray.x, lowest.y - ray.y, lowest.z - ray.z);
            double toHighest = along(axis, highest.x - ray.x, highest.y - ray.y, highest.z - ray.z);
            boolean startsHere = start == 2 * axis || start == 2 * axis + 1;
            if (startsHere && (start % 2 == 0 ? slope <= 0 : slope >= 0)) {
                return NO_HIT;
            }
            if (slope == 0) {
                if (toLowest > 0 || toHighest < 0) {
                    return NO_HIT;
                }
                continue;
            }
            double near = startsHere ? 0 : (slope > 0 ? toLowest : toHighest) / slope;
            double far = (slope > 0 ? toHighest : toLowest) / slope;
            // Math.max and Math.min also take care of NaN and of the sign of 0, and so take longer
            enter = near > enter ? near : enter;
            leave = far < leave ? far : leave;
        }
        if (start != NO_FACE) {
            return nearest(leave, 0, limit);
        }
        return enter <= leave ? nearest(enter, leave, limit) : NO_HIT;
    }

    private double along(int axis, double x, double y, double z) {
        Vector3d unit = axes[axis];
        return unit.x * x + unit.y * y + unit.z * z;
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        double x = ray.x + distance * ray.dx - centre.x;
        double y = ray.y + distance * ray.dy - centre.y;
        double z = ray.z + distance * ray.dz - centre.z;
        int face = NO_FACE;
        double outermost = Double.NEGATIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double position = along(axis, x, y, z);
            double depth = Math.abs(position) - half[axis];
            if (depth > outermost) {
                outermost = depth;
                face = 2 * axis + (position > 0 ? 1 : 0);
            }
        }
        Vector3d normal = axes[face / 2];
        double side = face % 2 == 0 ? -1 : 1;
        return memory.set(
                ray,
                distance,
                side * normal.x,
                side * normal.y,
                side * normal.z,
                this,
                face,
                faces == null ? null : faces[face].at(x, y, z));
    }

    /** Its eight corners: bit k of the number of a corner is 1 at the upper end of axis k. */
    public List<Vector3d> corners() {
        List<Vector3d> corners = new ArrayList<>();
        for (int corner = 0; corner < 8; corner++) {
            Vector3d place = new Vector3d(centre);
            for (int axis = 0; axis < 3; axis++) {
                place.fma((corner >> axis & 1) == 0 ? -half[axis] : half[axis], axes[axis]);
            }
            corners.add(place);
        }
        return corners;
    }

    @Override
    protected boolean isConvex() {
        return true;
    }

    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        double least = nx * centre.x + ny * centre.y + nz * centre.z;
        for (int axis = 0; axis < 3; axis++) {
            least -= Math.abs(along(axis, nx, ny, nz)) * half[axis];
        }
        return least;
    }
}
