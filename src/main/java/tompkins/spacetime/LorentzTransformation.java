package tompkins.spacetime;

import java.util.Arrays;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/**
 * The change of frame of special relativity (Courtial et al. 2016, Eq. 1, with the time): with u = gamma beta,
 *
 * <pre>x' = x + u ((u.x)/(gamma + 1) + t),   t' = gamma t + u.x</pre>
 *
 * A direction d that is traced backwards in time is the spatial part of the 4-vector (d, -|d|), so it takes the minus
 * sign: {@code d' = d + u ((u.d)/(gamma + 1) - |d|)}. (Eq. 2 of the paper has a plus sign because it speaks of the
 * direction in which the light travels.) Example: beta = (0, 0, 0.9), looking along +x, gives (0.43589, 0, -0.9).
 *
 * <p>Directions are evaluated by half angles: the difference of d and the direction of motion is stretched, not d
 * itself, which costs an error of a few gamma u (u = 2^-53) where the plain formula has gamma^2 u (see the charts of
 * the precision in docs/speed-and-accuracy.md).
 */
public final class LorentzTransformation implements SpaceTimeTransformation {

    private final Velocity velocity;
    private final double sign;

    // proper velocity, gamma, 1/(gamma + 1)
    private final double ux;
    private final double uy;
    private final double uz;
    private final double gamma;
    private final double shrink;

    // unit vector of the velocity, |u|, exp(-rapidity), exp(rapidity)
    private final double nx;
    private final double ny;
    private final double nz;
    private final double properSpeed;
    private final double forward;
    private final double backward;

    /** From the frame that moves with the given velocity into the frame in which it moves. */
    public LorentzTransformation(Velocity velocity) {
        this(velocity, 1);
    }

    private LorentzTransformation(Velocity velocity, double sign) {
        this.velocity = velocity;
        this.sign = sign;
        ux = sign * velocity.proper().x();
        uy = sign * velocity.proper().y();
        uz = sign * velocity.proper().z();
        gamma = velocity.gamma();
        shrink = 1 / (gamma + 1);
        nx = sign * velocity.direction().x();
        ny = sign * velocity.direction().y();
        nz = sign * velocity.direction().z();
        properSpeed = velocity.properSpeed();
        forward = velocity.expMinusRapidity();
        backward = gamma + properSpeed;
    }

    @Override
    public Event transform(Event event) {
        double along = alongProper(event.x(), event.y(), event.z());
        double factor = along * shrink + event.time();
        return new Event(
                event.x() + ux * factor,
                event.y() + uy * factor,
                event.z() + uz * factor,
                gamma * event.time() + along);
    }

    @Override
    public PreciseEvent transform(PreciseEvent event) {
        return event.boosted(velocity, sign);
    }

    @Override
    public Ray transform(Ray ray, Ray memory) {
        if (ray.slowness != 1) {
            return transformSlow(ray, memory);
        }
        double side = alongDirection(ray.dx, ray.dy, ray.dz) > 0 ? 1 : -1;
        double wx = ray.dx - side * nx;
        double wy = ray.dy - side * ny;
        double wz = ray.dz - side * nz;
        double half = (wx * wx + wy * wy + wz * wz) / 2;
        // w's part along n is -h for a unit vector d; gamma would magnify what the rounding of d leaves there
        double along = along(side, half) - alongDirection(wx, wy, wz);
        double length = length(side, half);
        double scale = 1 / length;
        double event = alongProper(ray.x, ray.y, ray.z);
        double factor = event * shrink + ray.time;
        return memory.setInFrame(
                ray,
                ray.x + ux * factor,
                ray.y + uy * factor,
                ray.z + uz * factor,
                (wx + nx * along) * scale,
                (wy + ny * along) * scale,
                (wz + nz * along) * scale,
                gamma * ray.time + event,
                1,
                length,
                length);
    }

    /**
     * Light in a medium, or a line of events, has the tangent (d, -s), with a slowness s that is not 1: {@code d' = d +
     * u ((u.d)/(gamma + 1) - s)}, {@code s' = (gamma s - u.d)/|d'|}, which is Fizeau's drag. The phase of a wave is the
     * same in both frames: its frequency is {@code gamma - s u.d} of what it is here.
     */
    private Ray transformSlow(Ray ray, Ray memory) {
        double slowness = ray.slowness;
        double along = alongProper(ray.dx, ray.dy, ray.dz);
        double push = along * shrink - slowness;
        double dx = ray.dx + ux * push;
        double dy = ray.dy + uy * push;
        double dz = ray.dz + uz * push;
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double event = alongProper(ray.x, ray.y, ray.z);
        double factor = event * shrink + ray.time;
        return memory.setInFrame(
                ray,
                ray.x + ux * factor,
                ray.y + uy * factor,
                ray.z + uz * factor,
                dx / length,
                dy / length,
                dz / length,
                gamma * ray.time + event,
                (gamma * slowness - along) / length,
                gamma - slowness * along,
                length);
    }

    /** The formulas of {@link #transform(Ray, Ray)} again, in short loops without branches, which are fast. */
    @Override
    public void transform(RayPacket rays) {
        if (!rays.isInVacuum()) {
            SpaceTimeTransformation.super.transform(rays);
            return;
        }
        int count = rays.count();
        transformStarts(rays, count);
        int ahead = 0;
        for (int i = 0; i < count; i++) {
            ahead += isAhead(rays, i) ? 1 : 0;
        }
        if (ahead == 0 || ahead == count) {
            transformDirections(rays, 0, count, ahead > 0);
        } else {
            for (int i = 0; i < count; i++) {
                transformDirections(rays, i, i + 1, isAhead(rays, i));
            }
        }
    }

    private void transformStarts(RayPacket rays, int count) {
        for (int i = 0; i < count; i++) {
            double event = alongProper(rays.x[i], rays.y[i], rays.z[i]);
            double factor = event * shrink + rays.time[i];
            rays.time[i] = gamma * rays.time[i] + event;
            rays.x[i] += ux * factor;
            rays.y[i] += uy * factor;
            rays.z[i] += uz * factor;
        }
    }

    private boolean isAhead(RayPacket rays, int index) {
        return alongDirection(rays.dx[index], rays.dy[index], rays.dz[index]) > 0;
    }

    /** Transforms directions that all lie ahead, or all behind. */
    private void transformDirections(RayPacket rays, int from, int to, boolean ahead) {
        double side = ahead ? 1 : -1;
        double sideX = side * nx;
        double sideY = side * ny;
        double sideZ = side * nz;
        // the slowness is not known yet
        double[] halves = rays.slowness;
        for (int i = from; i < to; i++) {
            double wx = rays.dx[i] - sideX;
            double wy = rays.dy[i] - sideY;
            double wz = rays.dz[i] - sideZ;
            halves[i] = (wx * wx + wy * wy + wz * wz) / 2;
        }
        double alongMiddle = ahead ? forward : -backward;
        double lengthMiddle = ahead ? forward : backward;
        double alongSlope = -side * gamma;
        double lengthSlope = side * properSpeed;
        for (int i = from; i < to; i++) {
            double wx = rays.dx[i] - sideX;
            double wy = rays.dy[i] - sideY;
            double wz = rays.dz[i] - sideZ;
            double along = alongMiddle + alongSlope * halves[i] - alongDirection(wx, wy, wz);
            double scale = 1 / (lengthMiddle + lengthSlope * halves[i]);
            rays.dx[i] = (wx + nx * along) * scale;
            rays.dy[i] = (wy + ny * along) * scale;
            rays.dz[i] = (wz + nz * along) * scale;
        }
        for (int i = from; i < to; i++) {
            rays.frequency[i] *= lengthMiddle + lengthSlope * halves[i];
        }
        for (int i = from; i < to; i++) {
            rays.directionLength[i] *= lengthMiddle + lengthSlope * halves[i];
        }
        for (int i = from; i < to; i++) {
            rays.spread[i] /= lengthMiddle + lengthSlope * halves[i];
        }
        Arrays.fill(rays.slowness, from, to, 1);
    }

    private double along(double side, double half) {
        return side > 0 ? forward - gamma * half : gamma * half - backward;
    }

    private double length(double side, double half) {
        return side > 0 ? forward + properSpeed * half : backward - properSpeed * half;
    }

    private double alongDirection(double x, double y, double z) {
        return x * nx + y * ny + z * nz;
    }

    private double alongProper(double x, double y, double z) {
        return ux * x + uy * y + uz * z;
    }

    /**
     * The unit direction, in the other frame, of light traced backwards in the direction d (any length but 0).
     *
     * @param result receives the unit direction; may be d itself
     * @return |d'|/|d|: the frequency in the other frame divided by that in the first
     */
    public double direction(Vector3dc d, Vector3d result) {
        Vector3d unit = Vectors.unit(d);
        Ray turned = transform(Ray.from(0, 0, 0, unit.x, unit.y, unit.z, 0));
        result.set(turned.dx, turned.dy, turned.dz);
        return turned.frequency;
    }

    /**
     * Turns a direction alone, by the formulas of {@link #transform(Ray, Ray)}.
     *
     * @param velocity its speed counts
     * @param along unit vector of the motion
     * @param direction the unit vector to turn
     * @return the factor by which the direction grows before it is made of unit length again: small angles are divided
     *     by it
     */
    public static double turn(Velocity velocity, Vector3dc along, Vector3d direction) {
        double gamma = velocity.gamma();
        double properSpeed = velocity.properSpeed();
        double side = direction.dot(along) > 0 ? 1 : -1;
        Vector3d w = direction.fma(-side, along);
        double half = w.lengthSquared() / 2;
        // |d'| and d'.n at the nearer pole
        double pole = side > 0 ? velocity.expMinusRapidity() : gamma + properSpeed;
        double length = pole + side * properSpeed * half;
        w.fma(side * (pole - gamma * half) - w.dot(along), along).div(length);
        return length;
    }

    /** {@code t = -(u.x)/(gamma + 1)}: the paper's (1 - gamma)(beta.x)/(gamma beta^2), without its 0/0 at rest. */
    @Override
    public double fixedPointTime(Vector3dc position) {
        return -alongProper(position.x(), position.y(), position.z()) * shrink;
    }

    @Override
    public LorentzTransformation inverse() {
        return new LorentzTransformation(velocity, -sign);
    }
}
