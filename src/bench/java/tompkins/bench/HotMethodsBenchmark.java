package tompkins.bench;

import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.joml.Vector3d;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import tompkins.camera.PixelSampler;
import tompkins.camera.SamplePositions;
import tompkins.light.AmbientLight;
import tompkins.light.Illumination;
import tompkins.light.Lighting;
import tompkins.light.PointLight;
import tompkins.light.Sightline;
import tompkins.primitive.Primitive;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Cone;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.Triangle;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.spacetime.TransformationLaw;
import tompkins.studio.PaperStudios;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Response;
import tompkins.surface.Tracer;

/** What every ray goes through: nanoseconds for one call. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3)
@Measurement(iterations = 5)
@Fork(1)
@State(Scope.Benchmark)
public class HotMethodsBenchmark {

    private static final int RAYS = 1024;

    /** Rays around the middle of the picture, of which about half meet an object there. */
    @State(Scope.Benchmark)
    public static class Rays {

        private final Ray[] rays = new Ray[RAYS];

        @Setup
        public void make() {
            Random random = new Random(1);
            for (int i = 0; i < RAYS; i++) {
                Vector3d to = new Vector3d(random.nextDouble(-1.4, 1.4), random.nextDouble(-1.4, 1.4), 10).normalize();
                rays[i] = Ray.from(0, 0, 0, to.x, to.y, to.z, 0);
                rays[i].spread = 1e-3;
            }
        }
    }

    /** One object of each kind, in its usual place in front of the camera. */
    @State(Scope.Benchmark)
    public static class Shape {

        @Param({"Sphere", "Plane", "Cylinder", "Cone", "Box", "Disc", "Parallelogram", "Triangle"})
        public String shape;

        private Primitive primitive;

        @Setup
        public void make() {
            SceneObject object = List.<SceneObject>of(
                            Sphere.DEFAULT,
                            Plane.DEFAULT,
                            Cylinder.DEFAULT,
                            Cone.DEFAULT,
                            Box.DEFAULT,
                            Disc.DEFAULT,
                            Parallelogram.DEFAULT,
                            Triangle.DEFAULT)
                    .stream()
                    .filter(each -> each.getClass().getSimpleName().equals(shape))
                    .findFirst()
                    .orElseThrow();
            primitive = PrimitiveCollector.primitivesOf(object).get(0);
        }
    }

    /** A hit on a sphere, and a world with two lights and no shadows. */
    @State(Scope.Benchmark)
    public static class Lit implements Tracer, Lighting {

        private final Illumination illumination =
                new Illumination(List.of(AmbientLight.DEFAULT, PointLight.DEFAULT), this);
        private final ColouredSurface surface = new ColouredSurface(new Colour(1, 0, 0), Colour.WHITE);
        private final Ray ray = Ray.from(0, 0, 0, 0, 0, 1, 0);
        private final Hit hit =
                PrimitiveCollector.primitivesOf(Sphere.DEFAULT).get(0).hit(ray, 9);

        @Override
        public Colour colour(Ray next) {
            return Colour.BLACK;
        }

        @Override
        public Illumination illumination() {
            return illumination;
        }

        @Override
        public boolean find(int source, Hit point, Sightline sight) {
            sight.set(1, 1, -1, 0);
            return true;
        }

        @Override
        public boolean isClear(int source, Hit point, Sightline sight) {
            return true;
        }

        @Override
        public boolean shifts() {
            return false;
        }

        @Override
        public Colour seen(Colour light, Ray from, double dopplerFactor) {
            return light;
        }
    }

    private final SpaceTimeTransformation sceneFromCamera =
            TransformationLaw.LORENTZ.sceneFromCamera(PaperStudios.VELOCITY);
    private final PixelSampler sampler = new PixelSampler(1, true, false);
    private final RayPacket block = new RayPacket(RayPacket.MOST);
    private final SamplePositions places = new SamplePositions(RayPacket.MOST);

    /** A block is filled and takes the change of frame in its place. */
    @Benchmark
    @OperationsPerInvocation(RayPacket.MOST)
    public RayPacket transformation(Rays rays) {
        block.begin(RayPacket.MOST);
        for (int i = 0; i < RayPacket.MOST; i++) {
            block.set(i, rays.rays[i]);
        }
        sceneFromCamera.transform(block);
        return block;
    }

    @Benchmark
    @OperationsPerInvocation(RAYS)
    public double intersection(Rays rays, Shape shape) {
        double sum = 0;
        for (Ray ray : rays.rays) {
            double distance = shape.primitive.distance(ray, Primitive.NO_HIT);
            sum += distance < Primitive.NO_HIT ? distance : 0;
        }
        return sum;
    }

    @Benchmark
    public Response shading(Lit lit) {
        return lit.surface.respond(lit.ray, lit.hit, lit);
    }

    @Benchmark
    @OperationsPerInvocation(RayPacket.MOST)
    public SamplePositions sampler() {
        places.clear();
        for (int i = 0; i < RayPacket.MOST; i++) {
            places.addPixel(i, 3);
        }
        sampler.choose(places, 37);
        return places;
    }
}
