package tompkins.trace;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.Camera;
import tompkins.camera.EyeView;
import tompkins.camera.PictureRays;
import tompkins.camera.PixelSampler;
import tompkins.camera.SamplePositions;
import tompkins.camera.Sampler;
import tompkins.camera.StereoLayout;
import tompkins.light.LightShift;
import tompkins.light.LightSource;
import tompkins.light.Pulse;
import tompkins.light.RestingLight;
import tompkins.math.Vectors;
import tompkins.primitive.Bounds;
import tompkins.primitive.Placement;
import tompkins.ray.Medium;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.search.ObjectTree;
import tompkins.shutter.LensRay;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameTree;
import tompkins.spacetime.IdentityTransformation;
import tompkins.spacetime.LightInMedium;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.spacetime.TransformationLaw;
import tompkins.studio.LensEvent;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.surface.Surface;
import tompkins.world.FlashTimes;
import tompkins.world.FrameRoutes;
import tompkins.world.Surroundings;
import tompkins.world.World;

/**
 * What a picture needs, and no more: worked out once from a studio, used by all threads, and thrown away with the
 * picture. A camera at rest needs no change of frame, a pinhole no points on the lens, a studio without objects that
 * move with the camera no first search, a small scene no tree.
 */
public final class RenderPlan {

    private final Studio studio;
    private final SpaceTimeTransformation sceneFromCamera;
    private final PictureRays pictureRays;
    private final FrameTree frames;
    private final LightShift shift;

    /** The stars behind the scene; null if there are none. */
    private final StarField stars;

    private final World world;
    private final FrameRoutes routes;
    private final ObjectTree cameraFrame;

    /** The medium around the lens, if it need not be known how it moves there; null otherwise, and in vacuum. */
    private final Medium lensMedium;

    /** That of the scene through which the lens moves; null if there is none. */
    private final MovingMedium sceneMedium;

    /** Whether rays must know in which medium they are. */
    private final boolean keepsMedia;

    /** As if the lamps stood at the coordinates in the camera frame that they have at time 0. */
    private final List<RestingLight> cameraLights;

    private RenderPlan(Studio studio, RenderPlan previous) {
        this.studio = studio;
        sceneFromCamera = studio.sceneFromCamera();
        pictureRays = new PictureRays(
                studio.camera(), studio.settings().width(), studio.settings().height(), sceneFromCamera);
        Event lens = LensEvent.inCamera(studio);
        frames = FrameTree.near(lens, studio.transformation(), studio.velocity());
        world = previous != null && previous.world.isOf(studio, frames)
                ? previous.world
                : new World(studio, frames, this::imagePoint);
        routes = world.routes(frames);
        PrimitiveCollector collector = new PrimitiveCollector();
        collector.add("cameraFrame", studio.cameraFrame(), Placement.NONE);
        cameraFrame = new ObjectTree(collector.primitives(0));
        Medium around = LensMedium.around(lens, cameraFrame, world, routes);
        TransformationLaw law = studio.transformation();
        boolean moves = (world.moves() || !isAtRest()) && law != TransformationLaw.NONE;
        keepsMedia = moves && law == TransformationLaw.LORENTZ;
        sceneMedium = moves && around != null && around.frame() != routes.camera()
                ? new MovingMedium(around, law, routes)
                : null;
        lensMedium = sceneMedium == null ? around : null;
        cameraLights = studio.lights().stream().flatMap(LightSource::atRest).toList();
        // last, because it follows a ray by this plan
        shift = studio.shiftsColours() ? metered() : null;
        stars = studio.background() instanceof StarSky sky
                ? new StarField(
                        sky,
                        studio,
                        pictureRays,
                        around == null && !studio.camera().hasWideAperture(),
                        shift)
                : null;
    }

    /**
     * The plan for a studio's picture.
     *
     * @throws tompkins.property.InvalidPropertyException if an object is too large or too small to work with
     */
    public static RenderPlan of(Studio studio) {
        return of(studio, null);
    }

    /**
     * As above; takes over the scene of an earlier plan if it is the same.
     *
     * @param previous the earlier plan, or null
     */
    public static RenderPlan of(Studio studio, RenderPlan previous) {
        return new RenderPlan(studio, previous);
    }

    /**
     * The event, in the scene frame, at which a point that is fixed to the camera is photographed through the lens
     * centre, in the middle of the exposure time and of the sweep.
     */
    private Event imagePoint(Vector3dc point) {
        Vector3d fromLens = point.sub(studio.camera().position(), new Vector3d());
        if (fromLens.length() == 0) {
            return LensEvent.inScene(studio);
        }
        LensRay ray = pictureRays.between().chiefRay(Vectors.unit(fromLens));
        Camera camera = studio.camera();
        double later = camera.exposureTime() * SamplePositions.MIDDLE
                + camera.rollingShutter().sweep() / 2;
        double time = camera.shutter().transmissionTime(ray, sceneFromCamera) + later - fromLens.length();
        return sceneFromCamera.transform(new Event(point.x(), point.y(), point.z(), time));
    }

    /** The studio. */
    public Studio studio() {
        return studio;
    }

    /** What is seen, ready to be met by rays. */
    public World world() {
        return world;
    }

    /** What moves with the camera, ready to be met by rays. */
    public ObjectTree objectsBeforeLens() {
        return cameraFrame;
    }

    /** The camera, ready to take the picture. */
    public PictureRays pictureRays() {
        return pictureRays;
    }

    /** What becomes of the light of the scene on its way to the camera; null if it stays as it is. */
    public LightShift lightShift() {
        return shift;
    }

    /** Pixels in a row. */
    public int width() {
        return studio.settings().width();
    }

    /** Number of rows. */
    public int height() {
        return studio.settings().height();
    }

    /** The factor by which the light is multiplied at the end: exposure compensation. */
    public double exposure() {
        return Math.pow(2, studio.camera().exposureStops());
    }

    /** Whether a lamp flashes. */
    public boolean hasFlashes() {
        return world.lights().stream().anyMatch(light -> light.flash() instanceof Pulse);
    }

    /** Whether there are stars behind the scene, each in a few pixels. */
    public boolean hasStars() {
        return stars != null;
    }

    /** Whether nothing changes with time: everything rests in one frame, with neither clocks nor flashes. */
    public boolean isStill() {
        return isAtRest()
                && !world.moves()
                && !hasFlashes()
                && Stream.of(world.objects(0), cameraFrame)
                        .flatMap(objects -> objects.surfaces().stream())
                        .noneMatch(Surface::showsTime);
    }

    /** Boxes around the first bounded objects, where they are in the scene when the picture is taken. */
    public List<Bounds> sceneBounds(int most) {
        return world.bounds(LensEvent.inScene(studio).time(), most);
    }

    /** Whether the camera and the scene share one frame. */
    public boolean isAtRest() {
        return sceneFromCamera instanceof IdentityTransformation;
    }

    /** The places of the samples, for one thread. */
    private Sampler sampler() {
        return new PixelSampler(studio.settings().seed(), studio.camera().hasWideAperture(), blursInTime());
    }

    /** Whether the shutter stays open while what it sees changes. */
    public boolean blursInTime() {
        return studio.camera().exposureTime() > 0 && !isStill();
    }

    /** Whether samples of a pixel differ by more than their places in it, which a single sample does not show. */
    public boolean blurs() {
        return studio.camera().hasWideAperture() || blursInTime();
    }

    /** The unit direction in the camera frame of the ray through the centre of the lens for a point in pixels. */
    public Vector3dc chiefDirection(double x, double y) {
        return pictureRays.chiefDirection(x, y);
    }

    /** The middle of the picture in pixels; if each eye has its own part, that of the left eye's. */
    public Vector2dc middle() {
        EyeView view = pictureRays.views().get(0);
        return new Vector2d(view.width() / 2.0, view.height() / 2.0);
    }

    /** The history of the sample in the middle of the picture; null if it never crosses the shutter. */
    public SampleHistory middleHistory() {
        return SampleHistory.way(this, middle().x(), middle().y());
    }

    /**
     * The shift for the picture, metered in its middle, behind what moves with the camera; of two eyes it is that
     * between them, so that both pictures have one exposure.
     */
    private LightShift metered() {
        if (studio.camera().stereo().layout() != StereoLayout.NONE) {
            return RenderPlan.of(studio.withCamera(studio.camera().betweenEyes()), this).shift;
        }
        SampleHistory middle = middleHistory();
        if (middle != null && middle.sceneStart() != null) {
            return new LightShift(
                    studio.colours(), studio.metering(), middle.sceneDopplerFactor(), middle.sceneDirectionLength());
        }
        // no light of the scene comes from there: as if nothing stood before the lens
        Vector3dc direction = chiefDirection(middle().x(), middle().y());
        Ray ray = studio.sceneFromCamera().transform(Ray.from(0, 0, 0, direction.x(), direction.y(), direction.z(), 0));
        return new LightShift(studio.colours(), studio.metering(), 1 / ray.frequency, ray.directionLength);
    }

    /** A tracer for one thread, which adds to the given counts. */
    public SampleTracer tracer(RayCounts counts) {
        return tracer(counts, sampler(), null, true);
    }

    /** As {@link #tracer(RayCounts)}, with samples at other places. */
    public SampleTracer tracer(RayCounts counts, Sampler sampler) {
        return tracer(counts, sampler, null, true);
    }

    /** As {@link #tracer(RayCounts)}, watched by an observer. */
    SampleTracer tracer(RayCounts counts, PathObserver observer) {
        return tracer(counts, sampler(), observer, true);
    }

    private SampleTracer tracer(RayCounts counts, Sampler sampler, PathObserver observer, boolean withStars) {
        StarTracer starTracer = withStars && stars != null
                ? new StarTracer(stars, watcher -> tracer(new RayCounts(), sampler(), watcher, false))
                : null;
        int depth = studio.settings().maximumDepth();
        LightShift shiftAtHits = needsFrames() ? shift : null;
        RayTracer sceneTracer = new RayTracer(
                scene(counts),
                shiftAtHits,
                starTracer == null ? new BackgroundTracer(studio.background(), shiftAtHits) : starTracer,
                depth,
                counts,
                observer);
        SceneBehindCamera entry = new SceneBehindCamera(
                routes, lensMedium, sceneMedium, sceneTracer, needsFrames() ? null : shift, observer);
        RayTracer cameraTracer = cameraFrame.size() == 0
                ? null
                : new RayTracer(beforeLens(counts), null, entry, depth, counts, observer);
        return new SampleTracer(this, sampler, cameraTracer, entry, starTracer, counts);
    }

    /** Whether rays are searched for frame by frame, or light depends on the motion of what it leaves. */
    private boolean needsFrames() {
        // in a Galilean world the time that light takes from a lamp depends on that motion
        boolean hasCarrier = studio.transformation() == TransformationLaw.GALILEAN && !isAtRest();
        return world.moves()
                || keepsMedia && lensMedium != null
                || hasCarrier && hasFlashes()
                || stars != null && shift != null;
    }

    private Surroundings beforeLens(RayCounts counts) {
        TransformationLaw law = keepsMedia ? TransformationLaw.LORENTZ : TransformationLaw.NONE;
        return Surroundings.ofOneFrame(routes.camera(), cameraFrame, cameraLights, routes, law, counts);
    }

    private Surroundings scene(RayCounts counts) {
        return world.surroundings(routes, needsFrames() ? studio.transformation() : TransformationLaw.NONE, counts);
    }

    /** Finds what flash lamps do at hits, for one thread; null if no lamp flashes. */
    FlashWatch flashWatch() {
        return hasFlashes()
                ? new FlashWatch(
                        world.lights(),
                        scene(new RayCounts()),
                        beforeLens(new RayCounts()),
                        new FlashTimes(world, routes, studio.transformation()))
                : null;
    }

    /** What the medium around the lens does to the picture. */
    public List<String> mediumSentences() {
        return sceneMedium == null ? LensMedium.sentences(lensMedium) : sceneMedium.sentences();
    }

    /**
     * The light that the camera overtakes in a unit direction of its frame, in the rest frame of the medium around the
     * lens; null if there is none.
     */
    LightInMedium.Seen overtaken(Vector3dc direction) {
        return sceneMedium == null || studio.view() == View.MEASURED ? null : sceneMedium.overtaken(direction);
    }

    /** An event of a frame of the scene, in the coordinates of the scene itself. */
    Event inScene(int frame, Event event) {
        return routes.route(frame, 0).transform(event).plus(frames.origin(null));
    }

    /** Whether the motion shifts so much light out of sight that the middle of the picture stays dark. */
    public boolean isTooFaint() {
        return shift != null && shift.isTooFaint();
    }
}
