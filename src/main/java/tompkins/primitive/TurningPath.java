package tompkins.primitive;

import org.joml.Vector3d;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** A straight ray past objects that turn, in coordinates that turn with them. Memory of one thread. */
public final class TurningPath implements CurvedPath {

    private static final double ROUNDING = 0x1p-50;

    /** The largest speed of a point that is still below 1, whatever rounding does to its components. */
    private static final double FASTEST = 1 - 0x1p-50;

    /** How far before a hit its surface is asked for the normal, relative to the coordinates. */
    private static final double BEFORE = 0x1p-26;

    private final Rotation rotation;
    private final double axisX;
    private final double axisY;
    private final double axisZ;
    private final double centreX;
    private final double centreY;
    private final double centreZ;

    // the ray, from the centre
    private double startX;
    private double startY;
    private double startZ;
    private double dx;
    private double dy;
    private double dz;
    private double startAngle;
    private double rate;
    private double size;

    // the present place, from the centre, and the change of it with the distance
    private double distance;
    private double x;
    private double y;
    private double z;
    private double vx;
    private double vy;
    private double vz;

    private double entry;
    private double exit;
    private double bend;

    private final Hit edge = Hit.blank();

    /** The ray where it meets something, as the object sees it that does not turn. */
    private final Ray line = Ray.blank();

    /** Memory for paths past what turns. */
    public TurningPath(Rotation rotation) {
        this.rotation = rotation;
        axisX = rotation.axis().x();
        axisY = rotation.axis().y();
        axisZ = rotation.axis().z();
        centreX = rotation.centre().x();
        centreY = rotation.centre().y();
        centreZ = rotation.centre().z();
    }

    /** Makes this the path of a ray. */
    public void begin(Ray ray) {
        startX = ray.x - centreX;
        startY = ray.y - centreY;
        startZ = ray.z - centreZ;
        dx = ray.dx;
        dy = ray.dy;
        dz = ray.dz;
        startAngle = rotation.angle(ray.time);
        rate = -rotation.angularSpeed() * ray.slowness;
        size = largest(ray.x, ray.y, ray.z) + largest(centreX, centreY, centreZ);
        distance = Double.NaN;
    }

    private static double largest(double x, double y, double z) {
        return Math.abs(x) + Math.abs(y) + Math.abs(z);
    }

    /** By how much everything turns while the light passes a unit of length. */
    public double turning() {
        return Math.abs(rate);
    }

    /** A sum of the sizes of coordinates, with which rounding is compared. */
    public double size() {
        return size;
    }

    @Override
    public void go(double newDistance) {
        if (newDistance == distance) {
            return;
        }
        distance = newDistance;
        double px = startX + distance * dx;
        double py = startY + distance * dy;
        double pz = startZ + distance * dz;
        // the velocity past what turns: d minus that of the turn
        double qx = dx - rate * (axisY * pz - axisZ * py);
        double qy = dy - rate * (axisZ * px - axisX * pz);
        double qz = dz - rate * (axisX * py - axisY * px);
        double angle = startAngle + rate * distance;
        double cosine = Math.cos(angle);
        double sine = -Math.sin(angle);
        double along = (axisX * px + axisY * py + axisZ * pz) * (1 - cosine);
        x = px * cosine + (axisY * pz - axisZ * py) * sine + axisX * along;
        y = py * cosine + (axisZ * px - axisX * pz) * sine + axisY * along;
        z = pz * cosine + (axisX * py - axisY * px) * sine + axisZ * along;
        double vAlong = (axisX * qx + axisY * qy + axisZ * qz) * (1 - cosine);
        vx = qx * cosine + (axisY * qz - axisZ * qy) * sine + axisX * vAlong;
        vy = qy * cosine + (axisZ * qx - axisX * qz) * sine + axisY * vAlong;
        vz = qz * cosine + (axisX * qy - axisY * qx) * sine + axisZ * vAlong;
    }

    /** Notes where the ray enters and leaves a region in which everything turns; false if it does not come there. */
    public boolean enters(CylinderPrimitive region) {
        bend = turning() * (2 + turning() * region.radius());
        line.setLine(startX + centreX, startY + centreY, startZ + centreZ, dx, dy, dz, null, 0);
        double first = region.distance(line, Primitive.NO_HIT);
        if (first == Primitive.NO_HIT) {
            return false;
        }
        region.hit(line, first, edge);
        boolean startsInside = edge.cosine(line) > 0;
        line.setLine(edge.x, edge.y, edge.z, dx, dy, dz, region, edge.part);
        entry = startsInside ? 0 : first;
        exit = startsInside ? first : first + region.distance(line, Primitive.NO_HIT);
        return exit < Primitive.NO_HIT;
    }

    /** Whether a piece of it surely lies nearer to the axis than a distance. */
    public boolean isWithin(double radius, double from, double to) {
        return fromAxis(from) < radius && fromAxis(to) < radius;
    }

    private double fromAxis(double at) {
        double px = startX + at * dx;
        double py = startY + at * dy;
        double pz = startZ + at * dz;
        double along = axisX * px + axisY * py + axisZ * pz;
        return Math.sqrt(px * px + py * py + pz * pz - along * along) + rounding(at);
    }

    /** Where it enters; 0 if it starts inside. */
    public double entry() {
        return entry;
    }

    /** Where it leaves. */
    public double exit() {
        return exit;
    }

    @Override
    public double x() {
        return x + centreX;
    }

    @Override
    public double y() {
        return y + centreY;
    }

    @Override
    public double z() {
        return z + centreZ;
    }

    @Override
    public double vx() {
        return vx;
    }

    @Override
    public double vy() {
        return vy;
    }

    @Override
    public double vz() {
        return vz;
    }

    /** Inside the cylinder that it enters. */
    @Override
    public double bend() {
        return bend;
    }

    @Override
    public double rounding(double at) {
        return ROUNDING * (size + at);
    }

    /** The hit on a primitive at a distance, where that is when the ray meets it, with its velocity there. */
    public Hit hit(Ray ray, Primitive met, double at, Hit memory) {
        go(at);
        double speed = Math.sqrt(vx * vx + vy * vy + vz * vz);
        double before = BEFORE * (size + at) / speed;
        line.setInFrame(
                ray,
                x() - before * vx,
                y() - before * vy,
                z() - before * vz,
                vx / speed,
                vy / speed,
                vz / speed,
                ray.time,
                1,
                1,
                1);
        double onto = met.distance(line, 2 * before * speed);
        met.hit(line, onto < Primitive.NO_HIT ? onto : before * speed, memory);
        rotation.turn(memory, startAngle + rate * at);
        memory.set(ray, at, memory.normalX, memory.normalY, memory.normalZ, met, memory.part, memory.coordinates);
        Vector3d velocity = rotation.velocity(memory.x, memory.y, memory.z);
        // far from the camera rounding moves the place
        double pace = velocity.length();
        if (pace > FASTEST) {
            velocity.mul(FASTEST / pace);
        }
        memory.run(velocity.x, velocity.y, velocity.z);
        return memory;
    }
}
