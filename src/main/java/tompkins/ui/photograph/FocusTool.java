package tompkins.ui.photograph;

import java.awt.Cursor;
import java.awt.geom.Point2D;
import java.util.function.BooleanSupplier;
import java.util.function.DoublePredicate;
import tompkins.ui.picture.Asker;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.picture.PictureTool;
import tompkins.ui.ray.PixelReading;
import tompkins.ui.widget.Texts;

/** The tool that picks the distance of what is seen, until one is taken. */
final class FocusTool implements PictureTool {

    private final PictureCanvas canvas;
    private final Asker asker;

    /** Takes a distance, and says whether it is the wanted one; null while none is picked. */
    private DoublePredicate taker;

    /** Called when the wanted one was taken. */
    private final BooleanSupplier ending;

    FocusTool(PictureCanvas canvas, Asker asker, BooleanSupplier ending) {
        this.canvas = canvas;
        this.asker = asker;
        this.ending = ending;
    }

    /** Picks for a taker from now on; for none if that is null. */
    void setTaker(DoublePredicate newTaker) {
        taker = newTaker;
        asker.drop(this);
    }

    @Override
    public boolean isWanted() {
        return taker != null;
    }

    @Override
    public String hint() {
        return Texts.get("status.idle.PICK");
    }

    @Override
    public int cursor() {
        return Cursor.CROSSHAIR_CURSOR;
    }

    @Override
    public boolean drags() {
        return false;
    }

    @Override
    public void click(Point2D place, Picture seen) {
        Picture picture = canvas.shown().now();
        asker.ask(this, () -> PixelReading.of(picture, place), reading -> {
            if (taker.test(reading.depth(picture.studio().camera()))) {
                ending.getAsBoolean();
            }
        });
    }
}
