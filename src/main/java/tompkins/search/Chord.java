package tompkins.search;

import tompkins.primitive.CurvedPath;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;

/**
 * A piece of a curved path, on which shapes are met by straight lines that lie near it: where its chord or the tangent
 * in its middle meets a shape, tangents lead on to the place where the curve does. Where they do not, as where the
 * curve grazes the shape, both halves are searched. Missed is what comes between the chord and that tangent, and meets
 * neither. Memory of one thread, taken again and again.
 */
final class Chord {

    /** How often a piece is halved: its sag is then a millionth of a millionth of what it was. */
    private static final int MOST_HALVINGS = 20;

    /** Tangents that lead to a hit, each to the square of the distance at which the one before was. */
    private static final int MOST_TANGENTS = 5;

    /** By how much a grazing line may prolong that. */
    private static final double GRAZING = 1e3;

    private final CurvedPath path;
    private final int halvings;
    private final Ray line = Ray.blank();
    private Chord half;

    private double from;
    private double to;
    private double x;
    private double y;
    private double z;
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
        from = newFrom;
        to = newTo;
        path.go(from);
        x = path.x();
        y = path.y();
        z = path.z();
        path.go(to);
        wayX = path.x() - x;
        wayY = path.y() - y;
        wayZ = path.z() - z;
        inverseX = 1 / wayX;
        inverseY = 1 / wayY;
        inverseZ = 1 / wayZ;
        rounding = path.rounding(to);
        sag = path.bend() * (to - from) * (to - from) / 8 + rounding;
    }

    /** Whether the piece may come into the box of a node. */
    boolean isNear(TreeNode node) {
        return node.isNear(x, y, z, inverseX, inverseY, inverseZ, sag);
    }

    /** The first distance on the piece at which it meets a shape; {@link Primitive#NO_HIT} if it does not. */
    double first(Primitive shape) {
        double onChord = onChord(shape, null, 0);
        double guess = onChord < Primitive.NO_HIT ? onChord : onTangent(shape, (from + to) / 2, (to - from) / 2);
        if (!(guess <= to) || halvings == 0) {
            return onChord;
        }
        double found = settled(shape, guess);
        if (found < Primitive.NO_HIT) {
            return found;
        }
        double middle = (from + to) / 2;
        half().take(from, middle);
        double inFirst = half.first(shape);
        if (inFirst < Primitive.NO_HIT) {
            return inFirst;
        }
        half.take(middle, to);
        return half.first(shape);
    }

    /**
     * As {@link #first} on the piece at the start of a path that starts on a part of the shape. As far as the curve is
     * straight but for rounding, the shape itself knows that it starts there.
     */
    double firstBehindStart(Primitive shape, int part) {
        double straight = Math.min(to, Math.sqrt(8 * rounding / path.bend()));
        half().take(from, straight);
        double found = half.onChord(shape, shape, part);
        if (found < Primitive.NO_HIT || straight == to) {
            return found;
        }
        half.take(straight, to);
        return half.first(shape);
    }

    private Chord half() {
        if (half == null) {
            half = new Chord(path, halvings - 1);
        }
        return half;
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
            if (GRAZING * path.bend() * change * change <= rounding) {
                return next;
            }
            at = next;
            before = 2 * change + rounding;
        }
        return Primitive.NO_HIT;
    }
}
