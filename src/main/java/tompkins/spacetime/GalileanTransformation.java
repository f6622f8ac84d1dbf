package tompkins.spacetime;

import org.hipparchus.dfp.Dfp;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Ray;

/**
 * The change of frame of Newton's mechanics: {@code x' = x + beta t}, {@code t' = t}. Light takes time, but there is no
 * relativity; its speed is 1 in the first frame only. It is meant for teaching, to be compared with
 * {@link LorentzTransformation}.
 */
final class GalileanTransformation implements SpaceTimeTransformation {

    private final Velocity velocity;
    private final double sign;
    private final Vector3dc beta;

    /** From the frame that moves with the given velocity into the frame in which it moves. */
    GalileanTransformation(Velocity velocity) {
        this(velocity, 1);
    }

    private GalileanTransformation(Velocity velocity, double sign) {
        this.velocity = velocity;
        this.sign = sign;
        beta = velocity.components().mul(sign, new Vector3d());
    }

    @Override
    public Event transform(Event event) {
        double time = event.time();
        return new Event(event.x() + beta.x() * time, event.y() + beta.y() * time, event.z() + beta.z() * time, time);
    }

    @Override
    public PreciseEvent transform(PreciseEvent event) {
        Dfp time = event.coordinate(3);
        Dfp[] moved = new Dfp[4];
        for (int axis = 0; axis < 3; axis++) {
            moved[axis] = event.coordinate(axis)
                    .add(PreciseEvent.exact(beta.get(axis)).multiply(time));
        }
        moved[3] = time;
        return new PreciseEvent(moved);
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
        double dx = ray.dx - beta.x() * slowness;
        double dy = ray.dy - beta.y() * slowness;
        double dz = ray.dz - beta.z() * slowness;
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
                1 - slowness * (beta.x() * ray.dx + beta.y() * ray.dy + beta.z() * ray.dz),
                length);
    }

    /** 0: at t = 0 all places coincide. */
    @Override
    public double fixedPointTime(Vector3dc position) {
        return 0;
    }

    @Override
    public SpaceTimeTransformation inverse() {
        return new GalileanTransformation(velocity, -sign);
    }
}
