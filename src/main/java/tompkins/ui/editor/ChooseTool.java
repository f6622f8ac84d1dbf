package tompkins.ui.editor;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import tompkins.measure.SeenLamp;
import tompkins.studio.StudioPath;
import tompkins.trace.RenderPlan;
import tompkins.ui.model.StudioModel;
import tompkins.ui.photograph.PhotographView;
import tompkins.ui.picture.Mark;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureTool;
import tompkins.ui.ray.PixelReading;
import tompkins.ui.widget.Texts;

/** The tool that chooses an object or a lamp for the editor. While it is wanted, lamps are marked. */
public final class ChooseTool implements PictureTool {

    private final StudioModel model;
    private final PhotographView view;
    private final BooleanSupplier wanted;
    private final Consumer<StudioPath> chooser;

    /**
     * Chooses in the photograph of a model.
     *
     * @param wanted whether the editor is open
     * @param chooser shows a part of the studio there
     */
    public ChooseTool(StudioModel model, PhotographView view, BooleanSupplier wanted, Consumer<StudioPath> chooser) {
        this.model = model;
        this.view = view;
        this.wanted = wanted;
        this.chooser = chooser;
        view.addTool(this);
        view.canvas().addOverlay((g, picture, bounds, visible, free) -> paintLamps(g, picture.plan(), bounds));
    }

    @Override
    public boolean isWanted() {
        return wanted.getAsBoolean();
    }

    @Override
    public String hint() {
        return Texts.get("status.idle.CHOOSE");
    }

    private void paintLamps(Graphics2D g, RenderPlan shown, Rectangle bounds) {
        if (isWanted()) {
            SeenLamp.of(shown)
                    .forEach(lamp -> Mark.paintLamp(
                            g,
                            bounds.x + lamp.place().x() * bounds.width / shown.width(),
                            bounds.y + lamp.place().y() * bounds.height / shown.height()));
        }
    }

    @Override
    public void click(Point2D place, Picture seen) {
        Point2D own = view.canvas().shown().placeIn(seen, place);
        view.asker()
                .ask(
                        this,
                        () -> PixelReading.of(seen, own),
                        reading -> SeenLamp.near(
                                        seen.plan(),
                                        reading.sighting().x(),
                                        reading.sighting().y())
                                .map(SeenLamp::path)
                                .or(() -> object(model, reading))
                                .ifPresent(chooser));
    }

    /** The object that is seen, if the studio of a model still holds it. */
    public static Optional<StudioPath> object(StudioModel model, PixelReading seen) {
        return Optional.ofNullable(seen.sighting().hit()).flatMap(hit -> StudioPath.to(model.studio(), hit.object()));
    }
}
