package tompkins.search;

import java.util.Arrays;
import tompkins.primitive.CurvedPath;
import tompkins.primitive.Primitive;
import tompkins.ray.Contact;
import tompkins.ray.Ray;

/**
 * A piece of a curved path, on which shapes are met by straight lines that lie near it. Where it comes near to a shape
 * it is cut into parts. Three lines are tried on a part: its chord, the tangent in its middle, and the chord of its
 * first half, since a thin sheet may pass between the other two. Where the chord meets the shape, tangents lead on to
 * the place where the curve does. Where they do not, as where the curve grazes the shape, and where only another line
 * meets it, both halves are searched. What none of the lines meets is missed. Memory of one thread.
 */
final class Chord {

    /** Into how many parts a piece is cut where it comes near to something. */
    static final int PARTS = 4;

    /** How often a part is halved: its sag is then a millionth of a millionth of what it was. */
    private static final int MOST_HALVINGS = 20;

    /** Tangents that lead to a hit, each to the square of the distance at which the one before was. */
    private static final int MOST_TANGENTS = 5;

    /** The first of them leads no farther than this, in sags; farther on it may be the other side of the shape. */
    private static final double STEEP = 2;

    /** By how much a grazing line may prolong that. */
    private static final double GRAZING = 1e3;

    private final CurvedPath path;
    private final int halvings;
    private final Ray line = Ray.blank();
    private Chord half;

    /** The parts of this piece, of which some were taken. */
    private Chord[] parts;

    private int takenParts;

    private double from;
    private double to;
    private double x;
    private double y;
    private double z;
    private double endX;
    private double endY;
    private double endZ;
    private double wayX;
    private double wayY;
    private double wayZ;
    private double inverseX;
    private double inverseY;
    private double inverseZ;
    private double sag;
    private double rounding;

    /** Memory for a piece of a path. */
    Chord(CurvedPath path) {
        this(path, MOST_HALVINGS);
    }

    private Chord(CurvedPath path, int halvings) {
        this.path = path;
        this.halvings = halvings;
    }

    /** Takes the piece between two distances along the ray. */
    void take(double newFrom, double newTo) {
        takenParts = 0;
        path.go(newFrom);
        to = newFrom;
        endX = path.x();
        endY = path.y();
        endZ = path.z();
        takeNext(newTo);
    }

    /** Takes the piece from the end of this one on. */
    void takeNext(double newTo) {
        from = to;
        to = newTo;
        x = endX;
        y = endY;
        z = endZ;
        path.go(to);
        endX = path.x();
        endY = path.y();
        endZ = path.z();
        wayX = endX - x;
        wayY = endY - y;
        wayZ = endZ - z;
        inverseX = 1 / wayX;
        inverseY = 1 / wayY;
        inverseZ = 1 / wayZ;
        rounding = path.rounding(to);
        sag = path.bend() * (to - from) * (to - from) / 8 + rounding;
    }

    /** Whether the piece may come into the box of a node. */
    boolean isNear(TreeNode node) {
        double coming = node.coming(x, y, z, inverseX, inverseY, inverseZ, sag);
        double leaving = node.leaving(x, y, z, inverseX, inverseY, inverseZ, sag);
        return !(coming > leaving || leaving < 0 || coming > 1);
    }

    /**
     * The first distance on the piece, up to a limit, at which it meets a shape in a box; {@link Primitive#NO_HIT} if
     * it does not. Only those parts are taken that may come into the box.
     */
    double first(Primitive shape, TreeNode box, Ray ray, double limit) {
        double coming = orElse(box.coming(x, y, z, inverseX, inverseY, inverseZ, sag), 0);
        double leaving = orElse(box.leaving(x, y, z, inverseX, inverseY, inverseZ, sag), 1);
        if (coming > leaving || leaving < 0 || coming > 1) {
            return Primitive.NO_HIT;
        }
        int startsOn = from == 0 ? ray.partOf(shape) : Contact.NOWHERE;
        double found = Primitive.NO_HIT;
        int last = (int) Math.min(PARTS - 1, PARTS * leaving);
        for (int i = (int) Math.max(0, PARTS * coming); i <= last && found == Primitive.NO_HIT; i++) {
            Chord part = part(i);
            if (part.from > limit) {
                break;
            }
            if (i == 0 && startsOn != Contact.NOWHERE) {
                found = part.firstBehindStart(shape, startsOn);
            } else if (part.isNear(box)) {
                found = part.first(shape);
            }
        }
        return found;
    }

    /** A number, or another one where a piece runs along a side of the box itself. */
    private static double orElse(double value, double otherwise) {
        return Double.isNaN(value) ? otherwise : value;
    }

    private Chord part(int number) {
        if (parts == null) {
            parts = new Chord[PARTS];
            Arrays.setAll(parts, i -> new Chord(path));
        }
        Chord part = parts[number];
        if ((takenParts & 1 << number) == 0) {
            takenParts |= 1 << number;
            double length = (to - from) / PARTS;
            part.take(from + number * length, number + 1 == PARTS ? to : from + (number + 1) * length);
        }
        return part;
    }

    /** The first distance on the piece at which it meets a shape; {@link Primitive#NO_HIT} if it does not. */
    private double first(Primitive shape) {
        double onChord = onChord(shape, null, 0);
        double middle = (from + to) / 2;
        if (halvings == 0
                || onChord == Primitive.NO_HIT
                        && !(onTangent(shape, middle, (to - from) / 2) <= to)
                        && !meetsFirstHalf(shape)) {
            return onChord;
        }
        double found = onChord < Primitive.NO_HIT ? settled(shape, onChord) : Primitive.NO_HIT;
        if (found < Primitive.NO_HIT) {
            return found;
        }
        half().take(from, middle);
        double inFirst = half.first(shape);
        if (inFirst < Primitive.NO_HIT) {
            return inFirst;
        }
        half.takeNext(to);
        return half.first(shape);
    }

    /**
     * As {@link #first} on the piece at the start of a path that starts on a part of the shape. As far as the curve is
     * straight but for rounding, the shape itself knows that it starts there.
     */
    private double firstBehindStart(Primitive shape, int part) {
        double straight = Math.min(to, Math.sqrt(8 * rounding / path.bend()));
        half().take(from, straight);
        double found = half.onChord(shape, shape, part);
        if (found < Primitive.NO_HIT || straight == to) {
            return found;
        }
        half.takeNext(to);
        return half.first(shape);
    }

    private Chord half() {
        if (half == null) {
            half = new Chord(path, halvings - 1);
        }
        return half;
    }

    /** Whether the chord of the half up to the present place meets a shape. */
    private boolean meetsFirstHalf(Primitive shape) {
        double halfX = path.x() - x;
        double halfY = path.y() - y;
        double halfZ = path.z() - z;
        double length = Math.sqrt(halfX * halfX + halfY * halfY + halfZ * halfZ);
        line.setLine(x, y, z, halfX / length, halfY / length, halfZ / length, null, 0);
        return shape.distance(line, length) < Primitive.NO_HIT;
    }

    private double onChord(Primitive shape, Primitive start, int part) {
        double length = Math.sqrt(wayX * wayX + wayY * wayY + wayZ * wayZ);
        line.setLine(x, y, z, wayX / length, wayY / length, wayZ / length, start, part);
        return from + shape.distance(line, length + rounding) * ((to - from) / length);
    }

    /** Where the tangent at a distance along the ray meets a shape, from a distance before that on. */
    private double onTangent(Primitive shape, double at, double before) {
        path.go(at);
        double vx = path.vx();
        double vy = path.vy();
        double vz = path.vz();
        double speed = Math.sqrt(vx * vx + vy * vy + vz * vz);
        line.setLine(
                path.x() - before * vx,
                path.y() - before * vy,
                path.z() - before * vz,
                vx / speed,
                vy / speed,
                vz / speed,
                null,
                0);
        return at - before + shape.distance(line, Primitive.NO_HIT) / speed;
    }

    /** Where the tangents lead from a guess; {@link Primitive#NO_HIT} if they leave the piece, or do not settle. */
    private double settled(Primitive shape, double guess) {
        double at = guess;
        double before = at - from + sag;
        for (int i = 0; i < MOST_TANGENTS; i++) {
            double next = onTangent(shape, at, before);
            if (!(next >= from - rounding && next <= to + rounding)) {
                return Primitive.NO_HIT;
            }
            double change = Math.abs(next - at);
            if (i == 0 && change > STEEP * sag) {
                return Primitive.NO_HIT;
            }
            if (GRAZING * path.bend() * change * change <= rounding) {
                return next;
            }
            at = next;
            before = 2 * change + rounding;
        }
        return Primitive.NO_HIT;
    }
}
