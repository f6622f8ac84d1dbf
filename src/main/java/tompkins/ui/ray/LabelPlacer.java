package tompkins.ui.ray;

import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** Finds places for the words of a drawing: inside it, off its lines, and off each other. */
public final class LabelPlacer {

    private final Rectangle2D room;
    private final List<Line2D> lines;
    private final List<Rectangle2D> taken = new ArrayList<>();

    /** Places in a room with some lines. */
    public LabelPlacer(Rectangle2D room, List<Line2D> lines) {
        this.room = room;
        this.lines = lines;
    }

    /** Takes the first of some places that is free, if there is one. */
    public Optional<Rectangle2D> takeFree(List<Rectangle2D> places) {
        Optional<Rectangle2D> free =
                places.stream().filter(place -> inTheWay(place) == 0).findFirst();
        free.ifPresent(taken::add);
        return free;
    }

    /** As above; if none is free, takes the first of those with the least in the way. */
    public Rectangle2D take(List<Rectangle2D> places) {
        Rectangle2D best =
                places.stream().min(Comparator.comparingLong(this::inTheWay)).orElseThrow();
        taken.add(best);
        return best;
    }

    private long inTheWay(Rectangle2D place) {
        long outside = room.contains(place) ? 0 : 1 + lines.size();
        return outside
                + lines.stream().filter(line -> line.intersects(place)).count()
                + taken.stream().filter(place::intersects).count();
    }
}
