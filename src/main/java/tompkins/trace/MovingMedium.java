package tompkins.trace;

import tompkins.ray.RayPacket;
import tompkins.spacetime.Event;
import tompkins.spacetime.TransformationLaw;
import tompkins.world.FrameCrossing;
import tompkins.world.FrameRoutes;
import tompkins.world.World;

/**
 * A medium of the scene in which the lens is, seen by a camera that moves through it. The tangent (d, -s) of a ray has,
 * in the rest frame of the medium, the slowness of the medium; this gives s for each direction.
 *
 * <p>Under the Lorentz transformation the time of the tangent in the medium is {@code q = G s - U.d}, and {@code s^2 -
 * 1 = (1 - 1/n^2) q^2}, because the length of a 4-vector is the same in all frames. In a Galilean world {@code n |d - w
 * s| = s}. Both are quadratic equations. Where the camera outruns the light of the medium there may be no solution: no
 * light comes from there.
 */
final class MovingMedium {

    private final double index;
    private final boolean galilean;

    // time in the medium's frame per unit of time and length in the camera frame, and velocity of the camera there
    private final double perTime;
    private final Event perLength;
    private final Event velocity;

    private MovingMedium(double index, TransformationLaw law, FrameCrossing crossing, FrameRoutes routes, int frame) {
        this.index = index;
        galilean = law == TransformationLaw.GALILEAN;
        Event zero = inMedium(Event.ORIGIN, crossing, routes, frame);
        velocity = inMedium(new Event(0, 0, 0, 1), crossing, routes, frame).minus(zero);
        perTime = velocity.time();
        perLength = new Event(
                inMedium(new Event(1, 0, 0, 0), crossing, routes, frame).time() - zero.time(),
                inMedium(new Event(0, 1, 0, 0), crossing, routes, frame).time() - zero.time(),
                inMedium(new Event(0, 0, 1, 0), crossing, routes, frame).time() - zero.time(),
                0);
    }

    private static Event inMedium(Event event, FrameCrossing crossing, FrameRoutes routes, int frame) {
        Event inScene = crossing.cross(event);
        return frame == 0 ? inScene : routes.transform(0, frame, inScene);
    }

    /**
     * The medium around the lens.
     *
     * @param lens an event at the lens, in the camera frame
     * @param routes the ways between the frames; null if there is only one
     * @return the medium, or null if the lens is in vacuum
     */
    static MovingMedium around(
            Event lens, World world, TransformationLaw law, FrameCrossing crossing, FrameRoutes routes) {
        for (int frame = 0; frame < world.frameCount(); frame++) {
            if (!world.refractive(frame).isEmpty()) {
                double index = LensMedium.slowness(
                        world.refractive(frame),
                        inMedium(lens, crossing, routes, frame).position());
                if (index != 1) {
                    return new MovingMedium(index, law, crossing, routes, frame);
                }
            }
        }
        return null;
    }

    /** Gives rays that have just left the camera their slowness, or no direction where no light comes from. */
    void fill(RayPacket rays) {
        for (int i = 0; i < rays.count(); i++) {
            rays.slowness[i] = slowness(rays.dx[i], rays.dy[i], rays.dz[i]);
            if (Double.isNaN(rays.slowness[i])) {
                rays.dx[i] = Double.NaN;
            }
        }
    }

    /** The slowness in the camera frame of light that is traced in a unit direction; NaN if there is none. */
    double slowness(double dx, double dy, double dz) {
        double a;
        double b;
        double c;
        if (galilean) {
            double squares = index * index;
            double along = velocity.x() * dx + velocity.y() * dy + velocity.z() * dz;
            a = squares * velocity.position().lengthSquared() - 1;
            b = squares * along;
            c = squares;
        } else {
            double share = (1 - 1 / index) * (1 + 1 / index);
            double along = perLength.x() * dx + perLength.y() * dy + perLength.z() * dz;
            a = share * perTime * perTime - 1;
            b = share * perTime * along;
            c = share * along * along + 1;
        }
        double divisor = b + Math.sqrt(b * b - a * c);
        return divisor > 0 ? c / divisor : Double.NaN;
    }
}
