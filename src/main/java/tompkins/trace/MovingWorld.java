package tompkins.trace;

import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.search.NearestHit;
import tompkins.spacetime.TransformationLaw;
import tompkins.world.FrameRoutes;
import tompkins.world.LampWays;
import tompkins.world.World;
import tompkins.world.WorldSearch;

/** What a thread needs to follow rays through a scene in which something moves; a scene at rest has none. */
final class MovingWorld {

    private final FrameRoutes routes;
    private final WorldSearch search;
    private final LampWays lampWays;
    private final LightShift shift;

    /**
     * The world of a thread.
     *
     * @param law how coordinates change between the frames
     * @param shift what becomes of light on its way from a hit to the camera; null if it stays as it is
     */
    MovingWorld(
            World world,
            FrameRoutes routes,
            TransformationLaw law,
            LightShift shift,
            NearestHit nearest,
            RayCounts counts) {
        this.routes = routes;
        search = new WorldSearch(world, routes, nearest);
        lampWays = new LampWays(world, routes, law, counts);
        this.shift = shift;
    }

    void beginBlock() {
        lampWays.beginBlock();
    }

    WorldSearch search() {
        return search;
    }

    LampWays lampWays() {
        return lampWays;
    }

    /** Whether light is shifted where it leaves a hit, by the frequency in the frame of the hit. */
    boolean shifts() {
        return shift != null;
    }

    /**
     * The colour that light has for the camera.
     *
     * @param frequency that of the ray along which it is seen: in the frame in which it was sent out, divided by that
     *     in the camera frame
     * @param lampFactor frequency in that frame divided by that in the frame of the lamp that it comes from
     */
    Colour seen(Colour light, double frequency, double lampFactor) {
        return shift.seen(light, lampFactor, 1 / frequency);
    }

    /** The ray of a frame in the scene frame. */
    Ray inScene(int frame, Ray ray) {
        return routes.transform(frame, 0, ray, Ray.blank());
    }
}
