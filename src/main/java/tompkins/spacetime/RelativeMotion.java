package tompkins.spacetime;

import java.util.List;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * How a second frame moves in a first one, with all digits also where both move fast and nearly alike: with the proper
 * velocities u1 and u2 in a frame around both, the difference D = u2 - u1 and the difference of the Lorentz factors g =
 * D.(u1 + u2)/(gamma1 + gamma2), the proper velocity of the second in the first is {@code D + u1 ((u1.D)/(gamma1 + 1) -
 * g)}, and along the axes of the second {@code D + u2 ((u2.D)/(gamma2 + 1) - g)}.
 *
 * @param inFirst proper velocity of the second frame in the first, along the axes of the first
 * @param inSecond the same along the axes of the second; the opposite of that of the first in the second
 * @param turn takes vectors from the axes of the second to those of the first, by components
 */
public record RelativeMotion(Vector3dc inFirst, Vector3dc inSecond, Quaterniondc turn) {

    /** The Lorentz factor. */
    public double gamma() {
        return Math.sqrt(1 + inFirst.lengthSquared());
    }

    /**
     * The frequency that light has in the second frame, divided by that in the first: {@code gamma (1 + n b.d)}.
     *
     * @param index refractive index of a medium at rest in the first frame in which the light is; 1 in vacuum
     * @param dx unit direction in the first frame, traced backwards
     * @param dy its second component
     * @param dz its third component
     */
    public double frequency(double index, double dx, double dy, double dz) {
        return gamma() + index * (inFirst.x() * dx + inFirst.y() * dy + inFirst.z() * dz);
    }

    /** The velocity of a frame as one boost, and the rotation by which its axes are then turned. */
    private record Composed(ProperVelocity velocity, Quaterniondc turn) {

        /** From velocities that lead inwards, each in the frame that moves with those before it. */
        static Composed of(List<FrameMotion> motions) {
            Composed sum = new Composed(ProperVelocity.of(Velocity.REST), new Quaterniond());
            for (FrameMotion motion : motions) {
                ProperVelocity given = ProperVelocity.of(motion.velocity());
                ProperVelocity inner =
                        new ProperVelocity(sum.turn.transformInverse(given.proper(), new Vector3d()), given.gamma());
                Quaterniond turned = new Quaterniond(sum.turn).mul(sum.velocity.rotation(inner));
                sum = new Composed(sum.velocity.plus(inner), turned);
            }
            return sum;
        }
    }

    /**
     * The motion of a second frame in a first one; each is given by the motions that lead to it from a frame around
     * both.
     */
    static RelativeMotion between(List<FrameMotion> toFirst, List<FrameMotion> toSecond) {
        Composed first = Composed.of(toFirst);
        Composed second = Composed.of(toSecond);
        Vector3dc u1 = first.velocity.proper();
        Vector3dc u2 = second.velocity.proper();
        double gamma1 = first.velocity.gamma();
        double gamma2 = second.velocity.gamma();
        Vector3d difference = u2.sub(u1, new Vector3d());
        double later = difference.dot(u1.add(u2, new Vector3d())) / (gamma1 + gamma2);
        Vector3d inFirst = new Vector3d(difference).fma(u1.dot(difference) / (gamma1 + 1) - later, u1);
        Vector3d inSecond = new Vector3d(difference).fma(u2.dot(difference) / (gamma2 + 1) - later, u2);
        Vector3d across = u1.cross(difference, new Vector3d());
        double gamma = Math.sqrt(1 + inFirst.lengthSquared());
        Quaterniond between = new Quaterniond(across.x, across.y, across.z, 1 + gamma1 + gamma2 + gamma).normalize();
        return new RelativeMotion(
                first.turn.transform(inFirst),
                second.turn.transform(inSecond),
                new Quaterniond(first.turn).mul(between).mul(second.turn.conjugate(new Quaterniond())));
    }
}
