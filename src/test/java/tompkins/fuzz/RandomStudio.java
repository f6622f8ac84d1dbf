package tompkins.fuzz;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.function.Supplier;
import org.joml.Vector2i;
import org.joml.Vector3d;
import org.joml.Vector3i;
import tompkins.camera.Camera;
import tompkins.camera.Cameras;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.Stereo;
import tompkins.camera.StereoLayout;
import tompkins.image.ToneCurve;
import tompkins.lesson.LessonPlan;
import tompkins.light.AlwaysOn;
import tompkins.light.AmbientLight;
import tompkins.light.ColourLaw;
import tompkins.light.Flash;
import tompkins.light.LightSource;
import tompkins.light.Metering;
import tompkins.light.MovingLights;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Colour;
import tompkins.ray.MeshData;
import tompkins.ray.PixelPicture;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Cone;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.CylinderLattice;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Ellipsoid;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Hidden;
import tompkins.sceneobject.ImagePointGrid;
import tompkins.sceneobject.Lens;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.Rotating;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Silhouette;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.Triangle;
import tompkins.sceneobject.TriangleMesh;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.ArbitraryPlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.shutter.FocusSurfaceShutter;
import tompkins.shutter.LensHologramShutter;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.Shutter;
import tompkins.shutter.SweepDirection;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Background;
import tompkins.studio.PanoramaBackground;
import tompkins.studio.RenderSettings;
import tompkins.studio.Ride;
import tompkins.studio.RideGoal;
import tompkins.studio.RideLeg;
import tompkins.studio.SkyBackground;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.studio.UniformBackground;
import tompkins.studio.View;
import tompkins.surface.Blinking;
import tompkins.surface.Clear;
import tompkins.surface.Clock;
import tompkins.surface.ColourFilter;
import tompkins.surface.ColouredSurface;
import tompkins.surface.ComplexRefraction;
import tompkins.surface.ConfocalLensletArray;
import tompkins.surface.CutOut;
import tompkins.surface.GalileoWindow;
import tompkins.surface.IdealLens;
import tompkins.surface.LorentzWindow;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Mirror;
import tompkins.surface.Mixture;
import tompkins.surface.PictureSurface;
import tompkins.surface.Refractive;
import tompkins.surface.Surface;
import tompkins.surface.Tiling;
import tompkins.surface.TwoSided;
import tompkins.surface.WindowAxes;

/**
 * Valid studios that nobody would build: all types, sizes over many powers of ten. The same seed gives the same one.
 */
public final class RandomStudio {

    private static final int TRIES = 1000;

    private static final Class<?>[] SURFACES =
            Descriptions.members(Surface.class).toArray(Class<?>[]::new);

    private final SplittableRandom random;

    /** Chooses how many eyes a camera has, so that all else of a studio does not depend on it. */
    private final SplittableRandom eyes;

    /** The exponents of ten of lengths and times go from minus to plus this. */
    private final double decades;

    /** What all objects look like, or null for all kinds of surfaces. */
    private final Surface uniform;

    /** Whether what is made is part of something that moves. */
    private boolean isMoving;

    private RandomStudio(long seed) {
        random = new SplittableRandom(seed);
        eyes = new SplittableRandom(~seed);
        decades = pick(1.5, 1.5, 1.5, 6.0, 6.0, 12.0, 40.0);
        uniform = null;
    }

    private RandomStudio(long seed, double decades, Surface uniform) {
        random = new SplittableRandom(seed);
        eyes = new SplittableRandom(~seed);
        this.decades = decades;
        this.uniform = uniform;
    }

    /** The studio with a number. */
    public static Studio of(long seed) {
        return new RandomStudio(seed).studio(RandomLesson.of(seed));
    }

    /** The studio with a number, with lengths and times from minus to plus so many powers of ten. */
    public static Studio of(long seed, double decades) {
        return new RandomStudio(seed, decades, null).studio(RandomLesson.of(seed));
    }

    /** An object of one type, of a size between 1/2 and 20, with the given surface. */
    public static SceneObject object(long seed, Class<?> type, Surface surface) {
        RandomStudio maker = new RandomStudio(seed, 0.8, surface);
        return maker.valid(() -> maker.object(type, 1));
    }

    /** A surface of one type. */
    public static Surface surface(long seed, Class<?> type) {
        RandomStudio maker = new RandomStudio(seed, 0.8, null);
        return maker.valid(() -> maker.surface(type, 1));
    }

    /** A shutter of one type. */
    public static Shutter shutter(long seed, Class<?> type) {
        RandomStudio maker = new RandomStudio(seed, 0.8, null);
        return maker.valid(() -> maker.shutter(type));
    }

    /** A camera with a shutter, of sizes between 1/2 and 20. */
    public static Camera camera(long seed) {
        RandomStudio maker = new RandomStudio(seed, 0.8, null);
        return maker.valid(maker::camera);
    }

    /** Tries until the checks of the descriptions accept something. */
    private <T> T valid(Supplier<T> making) {
        for (int i = 0; i < TRIES; i++) {
            try {
                return making.get();
            } catch (InvalidPropertyException refused) {
                // the next try may be accepted
            }
        }
        throw new IllegalStateException("no valid value in " + TRIES + " tries");
    }

    private Studio studio(LessonPlan lesson) {
        List<SceneObject> scene = several(random.nextInt(5) == 0 ? 150 : 6, this::anyObject);
        List<SceneObject> cameraFrame =
                random.nextInt(3) == 0 ? several(2, () -> valid(() -> atRest(anyObject()))) : List.of();
        return valid(() -> new Studio(
                "",
                "",
                "",
                scene,
                cameraFrame,
                several(3, this::light),
                background(),
                camera(),
                velocity(),
                pick(TransformationLaw.values()),
                random.nextInt(5) == 0 ? View.MEASURED : View.SEEN,
                pick(ColourLaw.values()),
                pick(Metering.values()),
                new RenderSettings(
                        16, 12, 1 + random.nextInt(2), 0, random.nextLong(), pick(10, 100, 1000), ToneCurve.LINEAR),
                several(2, this::leg),
                several(2, this::ride),
                lesson,
                ""));
    }

    private Ride ride() {
        return new Ride(
                "ride",
                "task",
                new Vector3d(size(), -size(), 0),
                velocity(),
                size(),
                several(2, this::leg),
                several(2, this::goal));
    }

    private RideGoal goal() {
        return new RideGoal(
                new Vector3d(size(), 0, -size()), size(), 1 + random.nextDouble(), 2 + size(), size(), size());
    }

    private RideLeg leg() {
        return new RideLeg(
                1 - random.nextDouble(),
                size(),
                new Vector3d(random.nextDouble(), -random.nextDouble(), 0),
                random.nextDouble(-180, 180),
                random.nextDouble(-90, 90),
                1 + random.nextDouble());
    }

    private static SceneObject atRest(SceneObject object) {
        return SceneObject.requireAtRest("object", object);
    }

    private SceneObject anyObject() {
        return valid(() -> object(pick(Descriptions.members(SceneObject.class).toArray(Class<?>[]::new)), 2));
    }

    private SceneObject object(Class<?> type, int depth) {
        String name = type.getSimpleName();
        return switch (name) {
            case "Sphere" -> new Sphere(name, place(), size(), surface());
            case "Ellipsoid" -> new Ellipsoid(name, place(), new Vector3d(size(), size(), size()), surface());
            case "Plane" -> new Plane(name, place(), direction(), surface());
            case "Disc" -> new Disc(name, place(), direction(), size(), surface());
            case "Parallelogram" -> new Parallelogram(name, place(), place(), place(), surface());
            case "Triangle" -> new Triangle(name, place(), place(), place(), surface());
            case "TriangleMesh" -> new TriangleMesh(name, MeshData.OCTAHEDRON, surface(), random.nextBoolean());
            case "Box" -> {
                Vector3d from = place();
                yield new Box(name, from, new Vector3d(size(), size(), size()).add(from), surface());
            }
            case "Cylinder" -> new Cylinder(name, place(), place(), size(), random.nextBoolean(), surface());
            case "Cone" -> new Cone(name, place(), place(), size(), random.nextBoolean(), surface());
            case "Lens" -> {
                double radius = size();
                yield new Lens(
                        name,
                        place(),
                        direction(),
                        radius,
                        random.nextBoolean() ? 0 : size(),
                        pick(sign(), 1.0) / radius,
                        sign() / radius,
                        surface());
            }
            case "CylinderLattice" -> {
                Vector3d from = place();
                yield new CylinderLattice(
                        name,
                        from,
                        new Vector3d(size(), size(), size()).add(from),
                        new Vector3i(2 + random.nextInt(3), 2 + random.nextInt(3), 2),
                        size() / 10,
                        surface(),
                        surface(),
                        surface());
            }
            case "Silhouette" -> new Silhouette(name, place(), place(), place(), picture(), surface());
            case "Group" -> new Group(name, depth == 0 ? List.of() : several(2, () -> objectWithin(depth)));
            case "Placed" ->
                new Placed(name, objectWithin(depth), size(), direction(), 360 * random.nextDouble(), place());
            case "ImagePointGrid" ->
                new ImagePointGrid(
                        name, objectWithin(depth), place(), place(), place(), new Vector2i(1 + random.nextInt(3), 2));
            case "Moving" ->
                moving(velocity -> new Moving(
                        name,
                        velocity,
                        place(),
                        number(),
                        depth == 0 ? List.of() : several(2, () -> objectWithin(depth))));
            case "Rotating" -> {
                List<SceneObject> objects = several(3, () -> valid(this::turning));
                yield new Rotating(name, place(), direction(), pick(0.0, -1.0, 1.0) * slow(objects), number(), objects);
            }
            case "Hidden" -> new Hidden(objectWithin(depth));
            default -> throw missing(type, "object");
        };
    }

    /** Something that may turn, however slowly. */
    private SceneObject turning() {
        Class<?> shape = pick(Sphere.class, Disc.class, Parallelogram.class, Box.class, Cylinder.class, Cone.class);
        SceneObject object = object(shape, 0);
        return new Rotating("", new Vector3d(), new Vector3d(0, 0, 1), 0, 0, List.of(object))
                .objects()
                .get(0);
    }

    /** An angular speed with which everything stays slower than light. */
    private double slow(List<SceneObject> objects) {
        double farthest = objects.stream()
                .flatMap(object -> PrimitiveCollector.primitivesOf(object).stream())
                .mapToDouble(primitive -> primitive.bounds().farthest())
                .max()
                .orElse(1);
        return random.nextDouble() / (4 * (farthest + Math.pow(10, decades)));
    }

    private SceneObject objectWithin(int depth) {
        return depth == 0
                ? new Sphere("ball", new Vector3d(), 1, surface())
                : object(pick(Descriptions.members(SceneObject.class).toArray(Class<?>[]::new)), depth - 1);
    }

    private Surface surface() {
        return uniform == null ? surface(pick(SURFACES), 2) : uniform;
    }

    private Surface surface(Class<?> type, int depth) {
        return switch (type.getSimpleName()) {
            case "ColouredSurface" -> new ColouredSurface(colour(), colour());
            case "LuminousSurface" -> new LuminousSurface(colour(), random.nextBoolean());
            case "PictureSurface" ->
                new PictureSurface(picture(), random.nextBoolean(), random.nextBoolean(), random.nextBoolean());
            case "Tiling" ->
                new Tiling(surfaceWithin(depth), surfaceWithin(depth), size(), size(), random.nextInt(4) > 0);
            case "CutOut" -> new CutOut(picture(), surfaceWithin(depth), surfaceWithin(depth));
            case "Clock" -> new Clock(size(), surfaceWithin(depth), surfaceWithin(depth), random.nextBoolean());
            case "Blinking" -> new Blinking(size(), surfaceWithin(depth), surfaceWithin(depth));
            case "Clear" -> Clear.DEFAULT;
            case "ColourFilter" ->
                new ColourFilter(new Colour(random.nextDouble(), random.nextDouble(), random.nextDouble()));
            case "Mirror" -> new Mirror(pick(0.0, 0.5, 0.9, 0.99, 1.0));
            case "Refractive" -> new Refractive(pick(1.0, 1 + 1e-12, 1.5, 0.5, 2.4, size()));
            case "LorentzWindow" -> new LorentzWindow(velocity(), pick(WindowAxes.values()), random.nextDouble());
            case "GalileoWindow" -> new GalileoWindow(velocity(), pick(WindowAxes.values()), random.nextDouble());
            case "ComplexRefraction" ->
                new ComplexRefraction(pick(1.0, 1.5, 0.5, size()), pick(0.0, 90.0, 180 * sign()), random.nextDouble());
            case "ConfocalLensletArray" ->
                new ConfocalLensletArray(
                        pick(1.0, -1.0, 0.3, 3.0), pick(1.0, -2.0, 0.5), sign(), sign(), random.nextDouble());
            case "IdealLens" ->
                new IdealLens(random.nextBoolean() ? size() : -size(), sign(), sign(), random.nextDouble());
            case "TwoSided" -> new TwoSided(surfaceWithin(depth), surfaceWithin(depth));
            case "Mixture" -> new Mixture(surfaceWithin(depth), surfaceWithin(depth), pick(0.0, 0.1, 0.5, 0.8, 1.0));
            default -> throw missing(type, "surface");
        };
    }

    private Surface surfaceWithin(int depth) {
        return depth == 0 ? ColouredSurface.DEFAULT : surface(pick(SURFACES), depth - 1);
    }

    private LightSource light() {
        if (random.nextInt(6) == 0) {
            return moving(velocity -> new MovingLights(velocity, place(), several(2, this::light)));
        }
        return random.nextBoolean()
                ? new AmbientLight(colour())
                : new PointLight(place(), colour(), colour(), 100 * random.nextDouble(), flash());
    }

    private Flash flash() {
        double duration = size();
        return random.nextBoolean()
                ? AlwaysOn.DEFAULT
                : new Pulse(number(), duration, pick(0.0, duration, 1.5 * duration, 40 * duration));
    }

    private Background background() {
        return switch (random.nextInt(4)) {
            case 0 -> new UniformBackground(colour());
            case 1 -> new SkyBackground(colour(), colour(), colour());
            case 2 ->
                new StarSky(
                        pick(-2.0, 1.5, 6.5),
                        pick(0.01, 0.2, 100.0),
                        new Vector3d(0, number(), 1),
                        new Vector3d(1, 0, 0),
                        colour());
            default -> new PanoramaBackground(picture(), random.nextBoolean());
        };
    }

    private Camera camera() {
        Vector3d position = random.nextInt(3) == 0 ? place() : new Vector3d();
        double angle = pick(1e-6, 1.0, 20.0, 90.0, 179.9);
        Camera instant = random.nextInt(4) == 0
                ? Cameras.panorama(position, direction(), direction(), 360, 180, size(), 0, shutter())
                : Cameras.lens(
                        position,
                        direction(),
                        direction(),
                        angle,
                        0,
                        random.nextBoolean() ? 0 : size() / 20,
                        objectWithin(1),
                        random.nextInt(3) - 1,
                        shutter());
        Camera exposed =
                random.nextInt(3) == 0 ? Descriptions.with(instant, "exposureTime", Math.abs(number())) : instant;
        Camera rolling = random.nextInt(3) == 0
                ? Descriptions.with(
                        exposed,
                        "rollingShutter",
                        new RollingShutter(pick(SweepDirection.values()), Math.abs(number())))
                : exposed;
        boolean canTurn = !(rolling instanceof PanoramicCamera) || rolling.shutter() instanceof AperturePlaneShutter;
        return eyes.nextInt(3) == 0 && canTurn ? rolling.withStereo(stereo()) : rolling;
    }

    private Stereo stereo() {
        StereoLayout[] layouts = StereoLayout.values();
        double distance = Math.pow(10, eyes.nextDouble(-decades, decades));
        return new Stereo(layouts[eyes.nextInt(layouts.length)], distance * eyes.nextDouble(), distance);
    }

    private Shutter shutter() {
        return shutter(pick(Descriptions.members(Shutter.class).toArray(Class<?>[]::new)));
    }

    private Shutter shutter(Class<?> type) {
        return switch (type.getSimpleName()) {
            case "AperturePlaneShutter" -> new AperturePlaneShutter(number());
            case "DetectorPlaneShutter" -> new DetectorPlaneShutter(number(), size());
            case "LensHologramShutter" -> new LensHologramShutter(number(), size());
            case "FocusSurfaceShutter" -> new FocusSurfaceShutter(number());
            case "ArbitraryPlaneShutter" -> new ArbitraryPlaneShutter(number(), place(), direction());
            case "FixedPointSurfaceShutter" -> FixedPointSurfaceShutter.DEFAULT;
            default -> throw missing(type, "shutter");
        };
    }

    private static IllegalStateException missing(Class<?> type, String method) {
        return new IllegalStateException("add " + type.getSimpleName() + " to RandomStudio." + method);
    }

    private Velocity velocity() {
        return switch (random.nextInt(4)) {
            case 0 -> Velocity.REST;
            case 1 ->
                Velocity.of(new Vector3d(random.nextDouble(), random.nextDouble(), random.nextDouble()).mul(0.57));
            case 2 -> Velocity.of(SpeedScale.ONE_MINUS_BETA, Math.pow(10, -12 * random.nextDouble()), direction());
            default -> Velocity.of(SpeedScale.RAPIDITY, Math.pow(10, 1.2 - 20 * random.nextDouble()), direction());
        };
    }

    /** Makes something that moves; within it nothing is so fast that all motions together are refused. */
    private <T> T moving(Function<Velocity, T> maker) {
        boolean outer = isMoving;
        Velocity velocity = velocity();
        isMoving = true;
        try {
            return maker.apply(outer && velocity.gamma() > 1.5 ? Velocity.of(0.3, -0.2, 0.5) : velocity);
        } finally {
            isMoving = outer;
        }
    }

    private Vector3d place() {
        // near the axis of the camera, so that there is something to see
        double reach = size();
        Vector3d place = new Vector3d(sign(), sign(), sign()).mul(reach);
        return random.nextInt(3) == 0 ? new Vector3d(number(), number(), number()) : place;
    }

    private double sign() {
        return random.nextInt(8) == 0 ? 0 : 2 * random.nextDouble() - 1;
    }

    private Vector3d direction() {
        return random.nextInt(3) == 0
                ? new Vector3d(random.nextInt(3) - 1, random.nextInt(3) - 1, random.nextInt(3) - 1)
                : new Vector3d(sign(), sign(), sign());
    }

    private double size() {
        return Math.pow(10, decades * (2 * random.nextDouble() - 1) + 0.5);
    }

    private double number() {
        return random.nextInt(10) == 0 ? 0 : random.nextBoolean() ? size() : -size();
    }

    private Colour colour() {
        return new Colour(random.nextDouble(), random.nextDouble(), random.nextDouble());
    }

    private PixelPicture picture() {
        int width = 1 + random.nextInt(4);
        float[] rgba = new float[4 * width * 2];
        for (int i = 0; i < rgba.length; i++) {
            rgba[i] = (float) random.nextDouble();
        }
        return new PixelPicture("random.png", width, 2, rgba, new byte[0]);
    }

    private <T> List<T> several(int most, Supplier<T> making) {
        List<T> list = new ArrayList<>();
        for (int count = random.nextInt(most + 1); count > 0; count--) {
            list.add(making.get());
        }
        return list;
    }

    @SafeVarargs
    private <T> T pick(T... values) {
        return values[random.nextInt(values.length)];
    }
}
