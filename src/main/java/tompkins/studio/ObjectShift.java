package tompkins.studio;

import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.light.MovingLights;
import tompkins.primitive.Placement;
import tompkins.primitive.Rotation;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Rotating;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.FrameRoute;
import tompkins.spacetime.FrameTree;
import tompkins.spacetime.TransformationLaw;

/**
 * What it takes to bring a point of an object elsewhere: a {@linkplain tompkins.sceneobject.SceneObject#shifted shift}
 * in the coordinates in which the object is described. Between these and the frame in which the point rests lie
 * placements, motions and turns. A motion that is shifted in the frame around it shifts what rests in it in place and
 * time: {@code x' = w + u ((u.w)/(gamma + 1))}, {@code t' = -u.w}.
 */
public final class ObjectShift {

    /** A turn that is late by the time part of the shift needs some steps; each leaves less of the error. */
    private static final int MOST_STEPS = 200;

    private final FrameRoute inwards;
    private final Placement placement;

    /** How the point turns about an axis that rests; null if it does not turn. */
    private final Rotation rotation;

    /** Whether the axis stays where it is when the object is shifted. */
    private final boolean axisStays;

    private ObjectShift(FrameRoute inwards, Placement placement, Rotation rotation, boolean axisStays) {
        this.inwards = inwards;
        this.placement = placement;
        this.rotation = rotation;
        this.axisStays = axisStays;
    }

    /**
     * The shift of an object of a studio.
     *
     * @param object the way to the object, or to a lamp
     * @param part the way to the part of it that has the point; it may be the object itself
     * @param rest the frame in which the part rests, or the axis about which it turns; null for the scene frame, and
     *     for that of the camera
     */
    public static ObjectShift of(Studio studio, StudioPath object, StudioPath part, FrameMotion rest) {
        TransformationLaw law = studio.transformation();
        int outside = object.steps().size();
        Placement placement = Placement.NONE;
        Placement ofObject = Placement.NONE;
        Rotation rotation = null;
        boolean axisStays = false;
        int frames = 0;
        for (int i = 0; i < part.steps().size(); i++) {
            Object whole = new StudioPath(part.steps().subList(0, i)).get(studio);
            if (whole instanceof Placed placed) {
                placement = placement.after(placed.placement());
            } else if (whole instanceof Moving moving
                    && i < outside
                    && !moving.velocity().isRest()) {
                frames++;
            } else if (whole instanceof MovingLights lamps && !lamps.velocity().isRest()) {
                frames++;
            } else if (whole instanceof Rotating rotating && rotating.turns(law)) {
                rotation = rotating.rotation(placement, 0, law);
                axisStays = i < outside;
            } else if (whole instanceof Rotating rotating) {
                placement = placement.after(rotating.atPhase());
            }
            if (i < outside) {
                ofObject = placement;
            }
        }
        FrameRoute inwards = FrameTree.described(law).route(outer(rest, frames), rest);
        return new ObjectShift(inwards, ofObject, rotation, axisStays);
    }

    /** The frame around a frame that lies in so many others. */
    private static FrameMotion outer(FrameMotion rest, int frames) {
        int depth = 0;
        for (FrameMotion each = rest; each != null; each = each.outer()) {
            depth++;
        }
        FrameMotion outer = rest;
        for (; depth > frames; depth--) {
            outer = outer.outer();
        }
        return outer;
    }

    /** By how much a shift moves what rests: place and time, in the frame in which it rests. */
    private Event moves(Vector3dc shift) {
        Vector3d placed = placement.vector(shift);
        return inwards.difference(new Event(placed.x, placed.y, placed.z, 0));
    }

    /** The columns are those by which shifts of 1 along x, y and z move what rests. */
    private Matrix3d columns() {
        return new Matrix3d(
                moves(new Vector3d(1, 0, 0)).position(),
                moves(new Vector3d(0, 1, 0)).position(),
                moves(new Vector3d(0, 0, 1)).position());
    }

    /**
     * The shift that brings a point to an event, all in the frame in which it rests or in which its axis does.
     *
     * @param point an event at which the point is now
     * @param velocity its velocity there; null if it does not turn
     * @param ownTime the time that its own clock has counted since the time that is described as 0
     * @param wanted the event
     */
    public Vector3d bringing(Event point, Vector3dc velocity, double ownTime, Event wanted) {
        Matrix3d back = columns().invert();
        if (rotation == null || velocity == null) {
            return back.transform(wanted.minus(point).position());
        }
        Vector3d arm = rotation.axis().cross(velocity, new Vector3d()).div(-rotation.angularSpeed());
        double slowing = rotation.law() == TransformationLaw.LORENTZ ? Math.sqrt(1 - velocity.lengthSquared()) : 1;
        double described = ownTime / slowing;
        Vector3d shift = new Vector3d();
        for (int step = 0; step < MOST_STEPS; step++) {
            double later = wanted.time() - moves(shift).time() - point.time();
            Vector3d turned =
                    rotation.turned(arm, rotation.angularSpeed() * later).sub(arm);
            Vector3d way = wanted.minus(point).position().sub(turned);
            Vector3d next = back.transform(axisStays ? rotation.turned(way, -rotation.angle(described + later)) : way);
            if (next.equals(shift)) {
                break;
            }
            shift = next;
        }
        return shift;
    }
}
