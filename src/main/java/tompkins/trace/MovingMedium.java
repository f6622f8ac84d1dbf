package tompkins.trace;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.NumberText;
import tompkins.ray.Medium;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.spacetime.LightInMedium;
import tompkins.spacetime.TransformationLaw;
import tompkins.world.FrameRoutes;

/**
 * A medium of the scene in which the lens is, seen by a camera that moves through it. Rays are carried in its rest
 * frame, because at high speed (d, -s) in the camera frame has lost what tells one ray from another: s differs from 1
 * by less than a double shows.
 *
 * <p>In a Galilean world the slowness s of a ray in the camera frame is a solution of {@code n |d - w s| = s}, with the
 * velocity w of the camera in the medium. Where the camera outruns the light of the medium there may be no solution: no
 * light comes from there.
 */
final class MovingMedium {

    private static final Vector3dc NOWHERE = new Vector3d(Double.NaN);

    private final Medium medium;
    private final FrameRoutes routes;

    /** Null in a Galilean world. */
    private final LightInMedium light;

    /**
     * A medium.
     *
     * @param medium where the lens is
     * @param law Lorentz or Galilean
     * @param routes the ways between the frames
     */
    MovingMedium(Medium medium, TransformationLaw law, FrameRoutes routes) {
        this.medium = medium;
        this.routes = routes;
        light = law == TransformationLaw.GALILEAN
                ? null
                : new LightInMedium(medium.index(), routes.motion(medium.frame(), routes.camera()));
    }

    /** Lets rays begin that have just left the camera; they get no direction where no light comes from. */
    void begin(RayPacket rays) {
        Vector3dc velocity =
                routes.route(routes.camera(), medium.frame()).worldLine().position();
        for (int i = 0; i < rays.count(); i++) {
            rays.slowness[i] = light == null
                    ? galileanSlowness(velocity.dot(rays.dx[i], rays.dy[i], rays.dz[i]), velocity.lengthSquared())
                    : light.slowness(rays.dx[i], rays.dy[i], rays.dz[i]);
            if (Double.isNaN(rays.slowness[i])) {
                rays.dx[i] = Double.NaN;
            }
        }
        rays.in(light == null ? null : medium);
    }

    private double galileanSlowness(double along, double squaredSpeed) {
        double squares = medium.index() * medium.index();
        double a = squares * squaredSpeed - 1;
        double b = squares * along;
        double divisor = b + Math.sqrt(b * b - a * squares);
        return divisor > 0 ? squares / divisor : Double.NaN;
    }

    /** Whether a ray that leaves the camera frame is in this medium, so that it goes on in its rest frame. */
    boolean holds(Medium other) {
        return other == medium;
    }

    /** Makes {@code memory} the ray of the camera frame in the rest frame of the medium. */
    Ray enter(Ray ray, Ray memory) {
        int frame = medium.frame();
        Ray start = routes.route(ray.frame, frame).transform(ray, memory);
        LightInMedium.Seen met = light.met(ray.dx, ray.dy, ray.dz);
        Vector3dc direction = met == null ? NOWHERE : met.direction();
        return memory.setInFrame(
                        ray,
                        start.x,
                        start.y,
                        start.z,
                        direction.x(),
                        direction.y(),
                        direction.z(),
                        start.time,
                        medium.index(),
                        met == null ? 1 : 1 / met.frequency(),
                        met == null ? 1 : met.length())
                .inFrame(frame);
    }

    /** The light that the camera overtakes in the same direction of its frame; null if there is none. */
    LightInMedium.Seen overtaken(Vector3dc look) {
        return light == null ? null : light.overtaken(look);
    }

    /** What this does to a picture, in sentences; empty if the camera rests in it. */
    List<String> sentences() {
        if (light == null || light.isAtRest()) {
            return List.of();
        }
        String moves = "The camera moves through a medium of index " + NumberText.plain(medium.index(), 4)
                + ": a direction of the picture is that of a ray there, not of the normal of its waves; the frequency is"
                + " that of the waves.";
        String outruns = "The camera is faster than light in the medium (1/n = "
                + NumberText.plain(1 / medium.index(), 4)
                + "): it shows the light that it meets; the light that it overtakes, from behind, is left out. Beside a"
                + " cone around its motion it sees nothing.";
        return light.isOutrun() ? List.of(moves, outruns) : List.of(moves);
    }
}
