package tompkins.world;

import java.util.ArrayList;
import java.util.List;
import tompkins.ray.Medium;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.FrameRoute;
import tompkins.spacetime.FrameTree;
import tompkins.spacetime.RelativeMotion;

/**
 * The ways between the frames of a world, and the frame of the camera, by their numbers. Each is computed when somebody
 * asks for it, because a scene with many frames needs few of all pairs. For any number of threads: those that ask at
 * once find the same.
 */
public final class FrameRoutes {

    private final FrameTree tree;
    private final List<FrameMotion> motions;

    /** As far as somebody asked. */
    private final FrameRoute[][] routes;

    /** How the frames move in each other, as far as somebody asked. */
    private final RelativeMotion[][] relative;

    /**
     * The ways between frames.
     *
     * @param motions those of the frames in the order of their numbers; the first is null, the scene frame
     * @param tree the frames, with that of the camera, which gets the last number
     */
    FrameRoutes(List<FrameMotion> motions, FrameTree tree) {
        List<FrameMotion> all = new ArrayList<>(motions);
        all.add(tree.camera());
        this.tree = tree;
        this.motions = all;
        relative = new RelativeMotion[all.size()][all.size()];
        routes = new FrameRoute[all.size()][all.size()];
    }

    /** The number of the camera frame. */
    public int camera() {
        return routes.length - 1;
    }

    /** Makes {@code memory}, which may be the ray itself, the same ray in another frame, where it starts on nothing. */
    public Ray transform(Ray ray, int to, Ray memory) {
        return ray.medium == null || ray.frame == to
                ? route(ray.frame, to).transform(ray, memory).inFrame(to)
                : transformInMedium(ray, to, memory);
    }

    /** In a medium the frequency goes with the wave, which is known from the ray in the rest frame of the medium. */
    private Ray transformInMedium(Ray ray, int to, Ray memory) {
        int from = ray.frame;
        Medium medium = ray.medium;
        double before = ray.frequency;
        if (from == medium.frame()) {
            double factor = motion(from, to).frequency(medium.index(), ray.dx, ray.dy, ray.dz);
            route(from, to).transform(ray, memory).inFrame(to);
            return memory.asWave(memory.slowness, before * factor);
        }
        if (to == medium.frame()) {
            route(from, to).transform(ray, memory).inFrame(to);
            double factor = motion(to, from).frequency(medium.index(), memory.dx, memory.dy, memory.dz);
            return memory.asWave(medium.index(), before / factor);
        }
        return transformInMedium(transformInMedium(ray, medium.frame(), memory), to, memory);
    }

    /** Takes each ray of a packet into another frame. */
    public void transform(RayPacket rays, int to) {
        if (rays.medium(0) == null) {
            route(rays.frame(), to).transform(rays);
        } else {
            for (int i = 0; i < rays.count(); i++) {
                Ray ray = rays.ray(i);
                rays.set(i, transform(ray, to, ray));
            }
        }
        rays.inFrame(to);
    }

    /** How a second frame moves in a first one. */
    public RelativeMotion motion(int first, int second) {
        RelativeMotion known = relative[first][second];
        if (known == null) {
            known = FrameTree.motion(motions.get(first), motions.get(second));
            relative[first][second] = known;
        }
        return known;
    }

    /** Whether the way from one frame to another is the way to a third one and then that from there. */
    boolean passesThrough(int from, int third, int to) {
        return route(from, third).length() + route(third, to).length()
                == route(from, to).length();
    }

    /** The way between two frames, for events in the coordinates in which the tracer works. */
    public FrameRoute route(int from, int to) {
        FrameRoute known = routes[from][to];
        if (known == null) {
            known = tree.route(motions.get(from), motions.get(to));
            routes[from][to] = known;
        }
        return known;
    }
}
