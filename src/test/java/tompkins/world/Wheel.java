package tompkins.world;

import java.util.List;
import org.joml.Vector3d;
import tompkins.golden.GoldenRow;
import tompkins.light.Sightline;
import tompkins.math.Vectors;
import tompkins.primitive.Primitive;
import tompkins.primitive.RestFrame;
import tompkins.primitive.Rotation;
import tompkins.ray.Ray;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Rotating;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.MomentaryRestFrame;
import tompkins.spacetime.Velocity;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Mirror;

/** A row of the reference data on what turns: its world, the ray, and what that meets. */
final class Wheel {

    final MovingRow scene;
    final boolean measures;
    final RestFrame rest;

    /** What is met in the frame of the axis, or null. */
    final FoundHit found;

    private final boolean isPlace;
    private final Rotation rotation;
    private final FrameMotion motion;
    private final Event placed;

    /** Distance at the camera. */
    final double lambda;

    /** The ray, the normal and the mirrored ray in the frame of the point. */
    Ray inPoint;

    Vector3d normal;
    Vector3d pointNormal;
    Ray mirrored;
    MomentaryRestFrame point;

    Wheel(GoldenRow row) {
        measures = row.has("kind", "place") || row.has("kind", "measured_ray");
        boolean isPoint = row.has("kind", "point") || row.has("kind", "place");
        Vector3d o = row.has("kind", "place") ? new Vector3d() : row.vector("o_");
        Event camera = new Event(o.x, o.y, o.z, row.number("T"));
        Vector3d towards = isPoint ? row.vector(row.has("kind", "point") ? "dir_" : "cam_") : row.vector("d_");
        SceneObject shape = isPoint
                ? screen(row, passing(row, scene(row, camera, screen(row, new Vector3d(0, 0, 1))), camera, towards))
                : MovingRow.shape(row, "_");
        scene = scene(row, camera, shape);
        found = scene.find(scene.inScene(camera, towards, measures));
        lambda = found == null ? Double.NaN : found.lambda();
        rest = found == null ? null : ((Primitive) found.hit.boundary).restFrame();
        isPlace = row.has("kind", "place");
        rotation = new Rotation(
                row.vector("c_"),
                Vectors.unit(row.vector("axis_")),
                row.number("omega"),
                row.number("phaseDegrees"),
                0,
                true);
        Vector3d p = row.vector("p_");
        motion = new FrameMotion(null, Velocity.of(row.vector("v_")), new Event(p.x, p.y, p.z, 0));
        placed = isPlace ? placed(row) : null;
        if (found != null) {
            enterPoint();
        }
    }

    private static MovingRow scene(GoldenRow row, Event camera, SceneObject shape) {
        Rotating turning = new Rotating(
                "wheel",
                row.vector("c_"),
                row.vector("axis_"),
                row.number("omega"),
                row.number("phaseDegrees"),
                List.of(shape));
        return MovingRow.lit(
                List.of(MovingRow.moving(row.vector("v_"), row.vector("p_"), row.number("tau0"), turning)),
                row.isNumber("lamp_x") ? row.vector("lamp_") : new Vector3d(),
                row.vector("beta_"),
                camera,
                row.has("law", "galilean"));
    }

    /** The velocity with which the ray passes the point, for a unit of distance. */
    private Vector3d passing(GoldenRow row, MovingRow world, Event camera, Vector3d towards) {
        int frame = world.world.objects(0).size() > 0 ? 0 : 1;
        Ray ray = world.routes.transform(world.inScene(camera, towards, measures), frame, Ray.blank());
        return new Vector3d(ray.dx, ray.dy, ray.dz).fma(ray.slowness, row.vector("V_"));
    }

    /** A small disc around the point, which faces what passes it. */
    private static Disc screen(GoldenRow row, Vector3d passing) {
        Vector3d q = row.vector("q_");
        Vector3d fromAxis = new Vector3d(q).sub(row.vector("c_"));
        Vector3d axis = Vectors.unit(row.vector("axis_"));
        double distance = fromAxis.fma(-fromAxis.dot(axis), axis).length();
        double omega = Math.abs(row.number("omega"));
        double room = omega == 0 ? 1 : 1 / omega - distance;
        double angle = Math.toRadians(row.number("phaseDegrees")) + row.number("omega") * row.number("ktau");
        Vector3d normal = new Vector3d(passing).rotateAxis(-angle, axis.x, axis.y, axis.z);
        return new Disc("point", q, normal, Math.min(1e-3, room / 4), ColouredSurface.DEFAULT);
    }

    private void enterPoint() {
        point = new MomentaryRestFrame(found.hit, scene.law);
        normal = found.normal();
        inPoint = point.enter(found.ray);
        point.enterHit();
        pointNormal = found.normal();
        mirrored = point.leave(new Mirror(1).respond(inPoint, found.hit, null).next());
    }

    /** A measured point is where it is at its time: a ray to it is aimed no better than rounding lets it. */
    private Event placed(GoldenRow row) {
        Vector3d place = rotation.turned(row.vector("q_").sub(row.vector("c_")), rotation.angle(row.number("ktau")))
                .add(row.vector("c_"));
        return new Event(place.x, place.y, place.z, row.number("ktau"));
    }

    /** The event in the frame of the axis. */
    Event inFrame() {
        return isPlace ? placed : traced().minus(rest.properTimeZero());
    }

    private Event traced() {
        return new Event(found.hit.x, found.hit.y, found.hit.z, found.hit.time);
    }

    /** Where the point is described, and its own time. */
    Event own() {
        return isPlace ? rotation.described(placed) : rest.own(traced());
    }

    Event inScene() {
        return isPlace ? motion.toScene(scene.law).transform(placed) : found.inScene();
    }

    Vector3d velocity() {
        return isPlace
                ? rotation.velocity(placed.x(), placed.y(), placed.z())
                : new Vector3d(found.hit.velocityX, found.hit.velocityY, found.hit.velocityZ);
    }

    /** What a clock shows there. */
    double reading() {
        return isPlace ? own().time() + rest.clockOffset() : found.hit.clockReading();
    }

    /** The velocity in the camera frame. */
    Vector3d velocityInCamera() {
        Vector3d v = velocity();
        Event pace = scene.routes.route(found.hit.frame, scene.routes.camera()).difference(new Event(v.x, v.y, v.z, 1));
        return pace.position().div(pace.time());
    }

    /** The way to the lamp in the frame of the point, as a ray of light, with the frequencies' ratio. */
    Ray toLamp() {
        Sightline way = new Sightline();
        scene.retardedLight().find(0, found.hit, way);
        double length = Math.sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
        Ray light = Ray.blank().setShadow(found.hit, way.x / length, way.y / length, way.z / length, 1);
        light.frequency = way.dopplerFactor;
        point.turn(light);
        return light;
    }
}
