package tompkins.spacetime;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Ray;

/**
 * The change of frame of Newton's mechanics: {@code x' = x + beta t}, {@code t' = t}. Light takes time, but there is no
 * relativity; its speed is 1 in the first frame only. It is meant for teaching, to be compared with
 * {@link LorentzTransformation}.
 */
final class GalileanTransformation implements SpaceTimeTransformation {

    /**
     * From this speed on, beta is described by how little it lacks to the speed of light, which keeps all digits. Below
     * it the components are used as they are given: the difference of d and beta loses three digits at most.
     */
    private static final double FAST = 0.999;

    private final Velocity velocity;
    private final double sign;
    private final Vector3dc beta;

    // beta is base - rest: at high speed base is its direction, and 1 - |beta| the length of rest
    private final boolean isFast;
    private final Vector3dc base;
    private final Vector3dc rest;

    /** From the frame that moves with the given velocity into the frame in which it moves. */
    GalileanTransformation(Velocity velocity) {
        this(velocity, 1);
    }

    private GalileanTransformation(Velocity velocity, double sign) {
        this.velocity = velocity;
        this.sign = sign;
        beta = velocity.components().mul(sign, new Vector3d());
        isFast = velocity.speed() > FAST;
        base = isFast ? velocity.direction().mul(sign, new Vector3d()) : beta;
        rest = isFast ? base.mul(velocity.oneMinusSpeed(), new Vector3d()) : new Vector3d();
    }

    @Override
    public Event transform(Event event) {
        double time = event.time();
        return new Event(event.x() + beta.x() * time, event.y() + beta.y() * time, event.z() + beta.z() * time, time);
    }

    @Override
    public PreciseEvent transform(PreciseEvent event) {
        return event.carried(beta);
    }

    /**
     * The tangent (d, dt) of the ray becomes (d + beta dt, dt). Its spatial part is no longer of length |dt|: the ray
     * keeps both, as a unit direction and a slowness. The phase of a wave is the same in both frames: its frequency in
     * the other one is {@code 1 - slowness beta.d} of what it is here, where a wave runs along its rays. The angles of
     * a narrow bundle are divided by |d + beta dt|; angles in the plane of d and beta also shrink by its inclination,
     * which is left out.
     */
    @Override
    public Ray transform(Ray ray, Ray memory) {
        double slowness = ray.slowness;
        double dx = ray.dx - base.x() * slowness + rest.x() * slowness;
        double dy = ray.dy - base.y() * slowness + rest.y() * slowness;
        double dz = ray.dz - base.z() * slowness + rest.z() * slowness;
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double time = ray.time;
        return memory.setInFrame(
                ray,
                ray.x + beta.x() * time,
                ray.y + beta.y() * time,
                ray.z + beta.z() * time,
                dx / length,
                dy / length,
                dz / length,
                time,
                slowness / length,
                frequency(ray),
                length);
    }

    /** {@code 1 - slowness beta.d}; at high speed {@code 1 - n.d} is half of the square of d - n. */
    private double frequency(Ray ray) {
        if (!isFast) {
            return 1 - ray.slowness * (beta.x() * ray.dx + beta.y() * ray.dy + beta.z() * ray.dz);
        }
        double wx = ray.dx - base.x();
        double wy = ray.dy - base.y();
        double wz = ray.dz - base.z();
        double half = (wx * wx + wy * wy + wz * wz) / 2;
        return 1 - ray.slowness + ray.slowness * (half + velocity.oneMinusSpeed() * (1 - half));
    }

    @Override
    public SpaceTimeTransformation inverse() {
        return new GalileanTransformation(velocity, -sign);
    }
}
