package tompkins.search;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReferenceArray;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Bounds;
import tompkins.ray.Ray;

/**
 * The straight way of a lamp past primitives, and what it sees of them on each piece of it. A piece is prepared when
 * light that was sent out there is asked for first. Shared by all threads.
 */
public final class LampTrack {

    /** What {@link #at} returns for a place for which nothing is prepared. */
    public static final double NOWHERE = -1;

    /** Fewer primitives than this are tested one by one in the same time. */
    private static final int LEAST_PRIMITIVES = 10;

    /** With more primitives than this it takes longer to prepare a piece than it saves in a picture. */
    private static final int MOST_PRIMITIVES = 20_000;

    /** The memory of the cells of a piece, as a number of primitives that take as much. */
    private static final int CELLS = 4_000;

    /** Length of a piece, in units of the least distance between the lamp and the middle of the primitives. */
    private static final double PIECE = 0.125;

    /** The middle piece is where the lamp is nearest. */
    private static final int PIECES = 64;

    /** How far rounding may move a place, in pieces: much less than the margins of what the lamp sees. */
    private static final double ROUNDING = 1e-9;

    /** Coordinates, in pieces, whose rounding stays below that. */
    private static final double LARGEST = 1e6;

    private record Piece(LampShadows seen) {}

    private final ObjectTree objects;
    private final AtomicLong left;
    private final Vector3d start;
    private final Vector3d step;
    private final double farthest;
    private final AtomicReferenceArray<Piece> pieces = new AtomicReferenceArray<>(PIECES);

    private final double perSquare;
    private final double mostBeside;

    private LampTrack(ObjectTree objects, AtomicLong left, Vector3d start, Vector3d step) {
        this.objects = objects;
        this.left = left;
        this.start = start;
        this.step = step;
        farthest = LARGEST * step.length();
        perSquare = 1 / step.lengthSquared();
        mostBeside = ROUNDING * ROUNDING * step.lengthSquared();
    }

    /**
     * The track of a lamp.
     *
     * @param from a place of the lamp
     * @param to another one
     * @param left primitives that all tracks together may still prepare, piece by piece
     * @return null if it is not worth while, because the primitives are few or very many, or if the lamp does not move
     */
    public static LampTrack of(Vector3dc from, Vector3dc to, ObjectTree objects, AtomicLong left) {
        if (objects.bounded().size() < LEAST_PRIMITIVES || objects.size() > MOST_PRIMITIVES || from.equals(to)) {
            return null;
        }
        Bounds all = objects.bounds();
        Vector3d direction = to.sub(from, new Vector3d()).normalize();
        Vector3d toCentre = all.centre().sub(from);
        Vector3d nearest =
                direction.mul(toCentre.dot(direction), new Vector3d()).add(from);
        double distance = Math.max(nearest.distance(all.centre()), all.halfDiagonal());
        Vector3d step = direction.mul(PIECE * distance);
        Vector3d start = step.mul(-PIECES / 2.0, new Vector3d()).add(nearest);
        double largest = all.farthest() + start.length();
        return largest < LARGEST * step.length() ? new LampTrack(objects, left, start, step) : null;
    }

    /**
     * Where on the track a lamp is, in pieces from its beginning; {@link #NOWHERE} if that is not on it.
     *
     * @param ray a ray to the lamp
     * @param distance distance of the lamp from the start of the ray
     */
    public double at(Ray ray, double distance) {
        double x = ray.x + distance * ray.dx - start.x;
        double y = ray.y + distance * ray.dy - start.y;
        double z = ray.z + distance * ray.dz - start.z;
        double along = (x * step.x + y * step.y + z * step.z) * perSquare;
        double besideX = x - along * step.x;
        double besideY = y - along * step.y;
        double besideZ = z - along * step.z;
        double beside = besideX * besideX + besideY * besideY + besideZ * besideZ;
        boolean known = along >= 0 && along < PIECES && beside <= mostBeside && distance < farthest;
        return known ? along : NOWHERE;
    }

    /** What the lamp sees on the piece of the track that holds a place, or null if the tree is faster. */
    public LampShadows seenFrom(double place) {
        int number = (int) place;
        Piece piece = pieces.get(number);
        return piece == null ? make(number).seen : piece.seen;
    }

    private synchronized Piece make(int number) {
        Piece piece = pieces.get(number);
        if (piece == null) {
            boolean hasRoom = left.addAndGet(-CELLS - objects.size()) >= 0;
            piece = new Piece(hasRoom ? LampShadows.of(place(number), place(number + 1), objects) : null);
            pieces.set(number, piece);
        }
        return piece;
    }

    private Vector3d place(int number) {
        return step.mul(number, new Vector3d()).add(start);
    }
}
