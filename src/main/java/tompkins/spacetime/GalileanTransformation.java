package tompkins.spacetime;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Ray;

/**
 * The change of frame of Newton's mechanics: {@code x' = x + beta t}, {@code t' = t}. Light takes its time, but there
 * is no relativity; its speed is 1 in the first frame only. For teaching, against {@link LorentzTransformation}.
 */
final class GalileanTransformation implements SpaceTimeTransformation {

    private final Vector3dc beta;

    /** From the frame that moves with the given velocity into the frame in which it moves. */
    GalileanTransformation(Velocity velocity) {
        this(velocity.components());
    }

    private GalileanTransformation(Vector3dc beta) {
        this.beta = new Vector3d(beta);
    }

    @Override
    public Event transform(Event event) {
        double time = event.time();
        return new Event(event.x() + beta.x() * time, event.y() + beta.y() * time, event.z() + beta.z() * time, time);
    }

    /** A fused multiplication and addition rounds once, and what it leaves is small. */
    @Override
    public Vector3d placeFrom(Vector3dc near, Event event) {
        double time = event.time();
        return new Vector3d(
                Math.fma(beta.x(), time, -near.x()) + event.x(),
                Math.fma(beta.y(), time, -near.y()) + event.y(),
                Math.fma(beta.z(), time, -near.z()) + event.z());
    }

    /**
     * The tangent (d, dt) of the ray becomes (d + beta dt, dt). Its spatial part is no longer of length |dt|: the ray
     * keeps both, as a unit direction and a slowness. The phase of a wave is the same in both frames: its frequency in
     * the other one is {@code 1 - slowness beta.d} of what it is here, where a wave runs along its rays. The angles of
     * a narrow bundle are divided by |d + beta dt|; that those in the plane of d and beta shrink by its inclination,
     * too, is left out.
     */
    @Override
    public Ray transform(Ray ray) {
        double dx = ray.dx - beta.x() * ray.slowness;
        double dy = ray.dy - beta.y() * ray.slowness;
        double dz = ray.dz - beta.z() * ray.slowness;
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double time = ray.time;
        return ray.inFrame(
                ray.x + beta.x() * time,
                ray.y + beta.y() * time,
                ray.z + beta.z() * time,
                dx / length,
                dy / length,
                dz / length,
                time,
                ray.slowness / length,
                1 - ray.slowness * (beta.x() * ray.dx + beta.y() * ray.dy + beta.z() * ray.dz),
                length);
    }

    /** 0: at t = 0 all places coincide. */
    @Override
    public double fixedPointTime(Vector3dc position) {
        return 0;
    }

    @Override
    public SpaceTimeTransformation inverse() {
        return new GalileanTransformation(beta.negate(new Vector3d()));
    }
}
