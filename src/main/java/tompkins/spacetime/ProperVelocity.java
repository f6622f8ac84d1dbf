package tompkins.spacetime;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The velocity of a frame as a four-vector: u = gamma beta, and gamma.
 *
 * @param proper u
 * @param gamma the Lorentz factor, which is sqrt(1 + u^2)
 */
record ProperVelocity(Vector3dc proper, double gamma) {

    static ProperVelocity of(Velocity velocity) {
        return new ProperVelocity(velocity.proper(), velocity.gamma());
    }

    static ProperVelocity of(Vector3dc proper) {
        return new ProperVelocity(proper, Math.sqrt(1 + proper.lengthSquared()));
    }

    /**
     * The composition of two velocities: {@code u = u2 + u1 ((u1.u2)/(gamma1 + 1) + gamma2)}, {@code gamma = gamma1
     * gamma2 + u1.u2}. It is not symmetric.
     *
     * @param inner u2, given in the frame that moves with this velocity
     */
    ProperVelocity plus(ProperVelocity inner) {
        double along = proper.dot(inner.proper);
        Vector3d sum = new Vector3d(inner.proper).fma(along / (gamma + 1) + inner.gamma, proper);
        return new ProperVelocity(sum, gamma * inner.gamma + along);
    }

    /**
     * The rotation (Thomas and Wigner) that two boosts leave beside the one boost with the sum of their velocities, by
     * components: the boost to the inner frame, after that to this one, is the boost to the sum and then this rotation.
     * Its quaternion is ((gamma1 + 1)(gamma2 + 1) + u1.u2, u1 x u2).
     */
    Quaterniond rotation(ProperVelocity inner) {
        Vector3d across = proper.cross(inner.proper, new Vector3d());
        double scalar = (gamma + 1) * (inner.gamma + 1) + proper.dot(inner.proper);
        return new Quaterniond(across.x, across.y, across.z, scalar).normalize();
    }
}
