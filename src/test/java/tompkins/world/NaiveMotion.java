package tompkins.world;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.golden.GoldenRow;
import tompkins.sceneobject.NaiveHits;
import tompkins.spacetime.Event;

/**
 * The change of frame as textbooks write it, with gamma from 1 - v.v, and hits by the discriminant. An event or a
 * tangent is one {@link Event} here.
 */
final class NaiveMotion {

    private final Vector3dc velocity;
    private final double gamma;

    NaiveMotion(Vector3dc velocity) {
        this.velocity = velocity;
        gamma = 1 / Math.sqrt(1 - velocity.lengthSquared());
    }

    /** An event or a tangent of the outer frame in that which moves. */
    Event into(Event outer) {
        Vector3d place = outer.position();
        double along = velocity.dot(place);
        double speedSquared = velocity.lengthSquared();
        double factor = (speedSquared == 0 ? 0 : (gamma - 1) * along / speedSquared) - gamma * outer.time();
        place.fma(factor, velocity);
        return new Event(place.x, place.y, place.z, gamma * (outer.time() - along));
    }

    Event outOf(Event inner) {
        return new NaiveMotion(velocity.negate(new Vector3d())).into(inner);
    }

    /** The distance at the camera of the hit of a row, on a sphere, a plane or a box. */
    static double lambda(GoldenRow row, boolean measures) {
        Vector3d d = row.vector("d").normalize();
        NaiveMotion camera = new NaiveMotion(row.vector("beta_"));
        NaiveMotion object = new NaiveMotion(row.vector("v"));
        Vector3d place = row.vector("p");
        Event start = object.into(
                camera.outOf(new Event(row.number("ox"), row.number("oy"), row.number("oz"), row.number("ot")))
                        .minus(new Event(place.x, place.y, place.z, 0)));
        Event tangent = object.into(camera.outOf(new Event(d.x, d.y, d.z, measures ? 0 : -1)));
        NaiveHits hits = new NaiveHits();
        return switch (row.text("shape")) {
            case "sphere" -> hits.sphere(start.position(), tangent.position(), row.vector("q1"), row.number("R"));
            case "plane" -> hits.plane(start.position(), tangent.position(), row.vector("q1"), row.vector("q2"));
            default -> hits.box(start.position(), tangent.position(), row.vector("q1"), row.vector("q2"));
        };
    }
}
