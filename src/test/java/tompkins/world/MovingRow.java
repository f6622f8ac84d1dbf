package tompkins.world;

import java.util.List;
import org.joml.Vector3d;
import tompkins.golden.GoldenRow;
import tompkins.light.LightSource;
import tompkins.light.MovingLights;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.math.Vectors;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameTree;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;

/** The world that a row of the reference data describes, made of the parts of which pictures are made. */
final class MovingRow {

    final World world;
    final FrameTree frames;
    final FrameRoutes routes;
    final TransformationLaw law;

    private MovingRow(List<SceneObject> scene, List<LightSource> lights, Vector3d beta, Event lens, boolean galilean) {
        law = galilean ? TransformationLaw.GALILEAN : TransformationLaw.LORENTZ;
        Studio studio = Lighting.of(Studio.DEFAULT.withScene(scene), lights)
                .withVelocity(Velocity.of(beta))
                .withTransformation(law);
        frames = FrameTree.near(lens, law, studio.velocity());
        world = new World(studio, frames, point -> Event.ORIGIN);
        routes = world.routes(frames);
    }

    /** A scene without lamps. */
    static MovingRow of(List<SceneObject> scene, Vector3d beta, Event lens, boolean galilean) {
        return new MovingRow(scene, List.of(), beta, lens, galilean);
    }

    /** A scene that one lamp lights, before a camera at rest. */
    static MovingRow lit(List<SceneObject> scene, Vector3d velocity, Vector3d place, Vector3d lamp, boolean galilean) {
        LightSource light = new PointLight(lamp, Colour.WHITE, Colour.WHITE, 1);
        return new MovingRow(
                scene,
                List.of(new MovingLights(Velocity.of(velocity), place, List.of(light))),
                new Vector3d(),
                Event.ORIGIN,
                galilean);
    }

    /** A scene that the lamp of a row lights with its flash. */
    static MovingRow flashed(GoldenRow row, List<SceneObject> scene, String place, Vector3d beta, Event lens) {
        PointLight lamp = new PointLight(row.vector("q_"), Colour.WHITE, Colour.BLACK, 1, flash(row));
        MovingLights moving = new MovingLights(Velocity.of(row.vector("vl_")), row.vector(place), List.of(lamp));
        boolean galilean = row.id().startsWith("m10f") && row.has("law", "galilean");
        return new MovingRow(scene, List.of(moving), beta, lens, galilean);
    }

    /** The flash of a row. */
    static Pulse flash(GoldenRow row) {
        return new Pulse(
                row.number("start"), row.number("duration"), row.isNumber("period") ? row.number("period") : 0);
    }

    /** A scene with a lamp that rests in it. */
    static MovingRow lit(List<SceneObject> scene, Vector3d lamp, Vector3d beta, Event lens, boolean galilean) {
        return new MovingRow(scene, List.of(new PointLight(lamp, Colour.WHITE, Colour.WHITE, 1)), beta, lens, galilean);
    }

    /** Objects that move. */
    static Moving moving(Vector3d velocity, Vector3d place, double clockOffset, SceneObject... objects) {
        return new Moving("moving", Velocity.of(velocity), place, clockOffset, List.of(objects));
    }

    /** The object of a row, described at rest. */
    static SceneObject shape(GoldenRow row, String joint) {
        ColouredSurface dull = ColouredSurface.DEFAULT;
        Vector3d first = row.vector("q1" + joint);
        return switch (row.text("shape")) {
            case "sphere" -> new Sphere("", first, row.number("R"), dull);
            case "plane" -> new Plane("", first, row.vector("q2" + joint), dull);
            case "disc" -> new Disc("", first, row.vector("q2" + joint), row.number("R"), dull);
            case "box" -> new Box("", first, row.vector("q2" + joint), dull);
            case "cylinder" ->
                new Cylinder("", first, row.vector("q2" + joint), row.number("R"), row.has("caps", "1"), dull);
            default -> throw new IllegalArgumentException(row.text("shape"));
        };
    }

    /** A ray of the camera frame in the scene frame; not of light but of events at one camera time, if it measures. */
    Ray inScene(Event from, Vector3d direction, boolean measures) {
        Vector3d d = Vectors.unit(direction);
        RayPacket rays = new RayPacket(1);
        rays.begin(1);
        rays.set(0, Ray.from(from.x(), from.y(), from.z(), d.x, d.y, d.z, from.time()));
        if (measures) {
            rays.measure();
        }
        return routes.route(routes.camera(), 0).transform(rays.ray(0), Ray.blank());
    }

    /** The search for what a ray of the scene frame meets first; null if it meets nothing. */
    FoundHit find(Ray ray) {
        Hit hit = surroundings().nearest(ray, Hit.blank());
        return hit == null ? null : new FoundHit(this, hit);
    }

    /** The ways of light from the lamps. */
    tompkins.light.Lighting retardedLight() {
        return surroundings().lighting();
    }

    private Surroundings surroundings() {
        return world.surroundings(routes, law, new RayCounts());
    }

    /** An event of a frame in the scene. */
    Event inScene(int frame, Event event) {
        return routes.route(frame, 0).transform(event).plus(frames.origin(null));
    }
}
