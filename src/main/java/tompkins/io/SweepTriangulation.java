package tompkins.io;

import java.util.Arrays;
import java.util.Comparator;
import java.util.TreeMap;

/**
 * Cuts a large flat face into triangles in a time that grows little faster than its corners: a line sweeps over it from
 * left to right and finds the diagonals that leave only monotone parts (de Berg et al., Computational Geometry, chapter
 * 3), and each part is cut in one walk along it. The face must not touch or cross itself; otherwise the triangles may
 * be wrong, which their areas show.
 */
final class SweepTriangulation {

    /** Stands for the corner at the sweeping line among the sides that it meets. */
    private static final int HERE = -1;

    private final double[] flat;
    private final int size;

    /** Sides with the inside above them that the line meets, by height, each with the last corner that sees it. */
    private final TreeMap<Integer, Integer> met = new TreeMap<>(new ByHeight());

    private int here;
    private final boolean[] isMerge;

    /** The two ends of each diagonal. */
    private int[] diagonals = new int[64];

    private int diagonalEnds;

    private final int[] triangles;
    private int count;

    private SweepTriangulation(double[] flat) {
        this.flat = flat;
        size = flat.length / 2;
        isMerge = new boolean[size];
        triangles = new int[3 * (size - 2)];
    }

    /**
     * Three corners for each triangle.
     *
     * @param flat x and y of each corner, counter-clockwise; no corner is at the same place as the one before it
     */
    static int[] triangles(double[] flat) {
        SweepTriangulation sweep = new SweepTriangulation(flat);
        Integer[] order = new Integer[sweep.size];
        Arrays.setAll(order, corner -> corner);
        Arrays.sort(order, sweep::leftToRight);
        for (int corner : order) {
            sweep.meet(corner);
        }
        sweep.cutParts();
        return Arrays.copyOf(sweep.triangles, sweep.count);
    }

    private int leftToRight(int corner, int other) {
        return corner == other ? 0 : isLeft(corner, other) ? -1 : 1;
    }

    /** If one corner is above the other, the lower one counts as left. */
    private boolean isLeft(int corner, int other) {
        int x = Double.compare(flat[2 * corner], flat[2 * other]);
        int order = x != 0 ? x : Double.compare(flat[2 * corner + 1], flat[2 * other + 1]);
        return order < 0 || order == 0 && corner < other;
    }

    private int next(int corner) {
        return corner + 1 == size ? 0 : corner + 1;
    }

    private int previous(int corner) {
        return corner == 0 ? size - 1 : corner - 1;
    }

    /** Positive if the third corner is to the left of the way from the first to the second. */
    private double turn(int first, int second, int third) {
        double x = flat[2 * first];
        double y = flat[2 * first + 1];
        return (flat[2 * second] - x) * (flat[2 * third + 1] - y) - (flat[2 * third] - x) * (flat[2 * second + 1] - y);
    }

    /**
     * Compares sides that the line meets at the same time; a side has the number of the corner where it begins, its
     * left end.
     */
    private final class ByHeight implements Comparator<Integer> {

        @Override
        public int compare(Integer side, Integer other) {
            if (side.equals(other)) {
                return 0;
            }
            if (side == HERE) {
                return -order(other, here, here);
            }
            if (other == HERE) {
                return order(side, here, here);
            }
            boolean isFirst = isLeft(side, other);
            int order = isFirst ? order(side, other, next(other)) : -order(other, side, next(side));
            return order != 0 ? order : Integer.compare(side, other);
        }

        /** Below 0 if a side is below two corners. */
        private int order(int side, int left, int right) {
            double above = turn(side, next(side), left);
            double decisive = above != 0 ? above : turn(side, next(side), right);
            return decisive > 0 ? -1 : decisive < 0 ? 1 : 0;
        }
    }

    private void meet(int corner) {
        here = corner;
        boolean comesFromLeft = isLeft(previous(corner), corner);
        boolean goesToRight = isLeft(corner, next(corner));
        boolean isConvex = turn(previous(corner), corner, next(corner)) > 0;
        if (comesFromLeft) {
            // the side that ends here has the inside above it
            Integer seenBy = met.remove(previous(corner));
            joinMerge(corner, seenBy);
        }
        boolean insideIsBelow = comesFromLeft == goesToRight ? !comesFromLeft : !isConvex;
        if (insideIsBelow) {
            Integer below = met.lowerKey(HERE);
            if (below != null) {
                boolean isSplit = !comesFromLeft && goesToRight;
                Integer seenBy = met.put(below, corner);
                if (isSplit) {
                    addDiagonal(corner, seenBy);
                } else {
                    joinMerge(corner, seenBy);
                }
            }
        }
        isMerge[corner] = comesFromLeft && !goesToRight && !isConvex;
        if (goesToRight) {
            met.put(corner, corner);
        }
    }

    private void joinMerge(int corner, Integer seenBy) {
        if (seenBy != null && isMerge[seenBy]) {
            addDiagonal(corner, seenBy);
        }
    }

    private void addDiagonal(int corner, int other) {
        if (diagonalEnds + 2 > diagonals.length) {
            diagonals = Arrays.copyOf(diagonals, 2 * diagonals.length);
        }
        diagonals[diagonalEnds++] = corner;
        diagonals[diagonalEnds++] = other;
    }

    /**
     * Walks along each part, with its inside on the left. At each corner the ways into the face are the side that
     * begins there and then, counter-clockwise, its diagonals; a walk that arrives along one of them leaves along the
     * one before it.
     */
    private void cutParts() {
        Integer[] byCorner = new Integer[diagonalEnds];
        Arrays.setAll(byCorner, end -> end);
        Arrays.sort(byCorner, this::byCornerAndAngle);
        // the ways from all corners, one corner after the other
        int[] side = new int[size];
        int[] last = new int[size];
        int[] wayOf = new int[diagonalEnds];
        int[] target = new int[size + diagonalEnds];
        int[] twin = new int[size + diagonalEnds];
        int way = 0;
        int sorted = 0;
        for (int corner = 0; corner < size; corner++) {
            side[corner] = way;
            target[way++] = next(corner);
            while (sorted < diagonalEnds && diagonals[byCorner[sorted]] == corner) {
                int end = byCorner[sorted++];
                wayOf[end] = way;
                target[way++] = diagonals[end ^ 1];
            }
            last[corner] = way - 1;
        }
        Arrays.fill(twin, -1);
        for (int end = 0; end < diagonalEnds; end++) {
            twin[wayOf[end]] = wayOf[end ^ 1];
        }
        boolean[] isWalked = new boolean[way];
        int[] part = new int[size + diagonalEnds];
        for (int start = 0; start < way; start++) {
            int length = 0;
            for (int at = start; !isWalked[at]; at = twin[at] < 0 ? last[target[at]] : twin[at] - 1) {
                isWalked[at] = true;
                part[length++] = target[at];
            }
            cutMonotone(part, length);
        }
    }

    private int byCornerAndAngle(int end, int other) {
        int corner = diagonals[end];
        if (corner != diagonals[other]) {
            return Integer.compare(corner, diagonals[other]);
        }
        int to = diagonals[end ^ 1];
        int toOther = diagonals[other ^ 1];
        boolean isFirstHalf = turn(corner, next(corner), to) > 0;
        boolean otherIsFirstHalf = turn(corner, next(corner), toOther) > 0;
        if (isFirstHalf != otherIsFirstHalf) {
            return isFirstHalf ? -1 : 1;
        }
        return Double.compare(0, turn(corner, to, toOther));
    }

    /** Cuts a part that the sweeping line always meets in one piece; corners run counter-clockwise. */
    private void cutMonotone(int[] part, int length) {
        if (length < 3) {
            return;
        }
        int leftmost = 0;
        int rightmost = 0;
        for (int i = 1; i < length; i++) {
            leftmost = isLeft(part[i], part[leftmost]) ? i : leftmost;
            rightmost = isLeft(part[rightmost], part[i]) ? i : rightmost;
        }
        int[] waiting = new int[length];
        int[] chains = new int[length];
        waiting[0] = part[leftmost];
        int waitingCount = 1;
        int lower = (leftmost + 1) % length;
        int upper = (leftmost + length - 1) % length;
        for (int met = 1; met < length; met++) {
            boolean isLast = met == length - 1;
            boolean isLower = upper == rightmost || lower != rightmost && isLeft(part[lower], part[upper]);
            int corner = isLower ? part[lower] : part[upper];
            int chain = isLast ? 0 : isLower ? 1 : -1;
            if (isLower) {
                lower = (lower + 1) % length;
            } else {
                upper = (upper + length - 1) % length;
            }
            int top = waitingCount - 1;
            if (met > 1 && chain != chains[top]) {
                for (int i = 0; i < top; i++) {
                    addTriangle(waiting[i], waiting[i + 1], corner);
                }
                waiting[0] = waiting[top];
                chains[0] = chains[top];
                waitingCount = 1;
            } else {
                while (top > 0 && chain * turn(waiting[top - 1], waiting[top], corner) > 0) {
                    addTriangle(waiting[top - 1], waiting[top], corner);
                    top--;
                }
                waitingCount = top + 1;
            }
            waiting[waitingCount] = corner;
            chains[waitingCount++] = chain;
        }
    }

    private void addTriangle(int first, int second, int third) {
        // only a face that crosses itself gives more of them than there can be
        if (count < triangles.length) {
            triangles[count++] = first;
            triangles[count++] = second;
            triangles[count++] = third;
        }
    }
}
