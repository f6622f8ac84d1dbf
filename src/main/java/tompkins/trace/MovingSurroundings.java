package tompkins.trace;

import tompkins.light.Sightline;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.search.NearestHit;
import tompkins.spacetime.TransformationLaw;
import tompkins.world.FrameRoutes;
import tompkins.world.RetardedLight;
import tompkins.world.World;
import tompkins.world.WorldSearch;

/** A scene in which something moves: each ray meets the objects of all frames. */
final class MovingSurroundings implements Surroundings {

    private final FrameRoutes routes;
    private final TransformationLaw law;
    private final NearestHit nearest;
    private final WorldSearch search;
    private final RetardedLight retardedLight;
    private final Ray left = Ray.blank();

    /** What becomes of light on its way from a hit to the camera; null if it stays as it is. */
    private final LightShift shift;

    /**
     * The surroundings of a scene.
     *
     * @param law how coordinates change between the frames
     * @param shift what becomes of light on its way from a hit to the camera; null if it stays as it is
     */
    MovingSurroundings(World world, FrameRoutes routes, TransformationLaw law, LightShift shift, RayCounts counts) {
        this.routes = routes;
        this.law = law;
        this.shift = shift;
        nearest = new NearestHit(counts);
        search = new WorldSearch(world, routes, nearest);
        retardedLight = new RetardedLight(world, routes, law, counts);
    }

    @Override
    public void begin(RayPacket rays) {
        retardedLight.beginBlock();
        search.begin(rays);
    }

    @Override
    public boolean mayMeet(int place) {
        return search.mayMeet(place);
    }

    @Override
    public boolean nearest(int place) {
        return search.nearest(place);
    }

    @Override
    public Ray met() {
        return search.ray();
    }

    @Override
    public boolean nearest(Ray ray) {
        return search.nearest(ray);
    }

    @Override
    public TransformationLaw law() {
        return law;
    }

    @Override
    public Hit hit(Hit memory) {
        return search.hit(memory);
    }

    /** Light is shifted where it leaves a hit, so the ray must know what becomes of it on the way before that. */
    @Override
    public Ray goesOn(Ray next, Colour weight) {
        return shift == null ? next : next.weighted(weight);
    }

    @Override
    public Ray leaving(Ray ray) {
        return routes.transform(ray, 0, left);
    }

    @Override
    public boolean find(int source, Hit hit, Sightline sight) {
        return retardedLight.find(source, hit, sight);
    }

    @Override
    public boolean isClear(int source, Hit from, Sightline sight) {
        return retardedLight.isClear(source, from, sight);
    }

    @Override
    public boolean shifts() {
        return shift != null;
    }

    @Override
    public Colour seen(Colour light, Ray ray, double dopplerFactor) {
        return shift.seen(light.times(ray.weight), dopplerFactor, 1 / ray.frequency, ray.directionLength);
    }
}
