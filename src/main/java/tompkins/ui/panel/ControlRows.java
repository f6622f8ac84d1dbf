package tompkins.ui.panel;

import java.util.List;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.ui.editor.StudioRow;
import tompkins.ui.model.StudioModel;
import tompkins.ui.number.SceneSize;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.SpeedText;
import tompkins.ui.widget.Texts;

/** The parts of the studio that are changed in front of a class; the editor has all the others. */
public final class ControlRows extends Part {

    /** Beyond gamma 10 a usual scene shrinks to a point. */
    private static final double FASTEST = 0.995;

    private final StudioModel model;
    private final SceneSize size = new SceneSize();

    /** The rows for a model, which follow its studio. */
    public ControlRows(StudioModel model) {
        super(Rows.of("wrap 2, hidemode 3, gap 6 5", "[pref!][grow,fill]"));
        this.model = model;
        StudioRow speed =
                new StudioRow(model, "velocity.beta", Texts.get("speed.name"), studio -> Range.speeds(FASTEST));
        List<StudioRow> rows = List.of(
                speed,
                new StudioRow(model, "colours", Texts.get("row.colours")),
                new StudioRow(model, "view", Texts.get("row.view")),
                new StudioRow(model, "camera.shutter", Texts.get("row.shutter")),
                new StudioRow(model, "camera.shutter.openingTime", Texts.get("row.openingTime"), size::times),
                new StudioRow(model, "camera.exposureTime", Texts.get("row.exposureTime"), this::exposures),
                new StudioRow(model, "camera.apertureRadius", Texts.get("row.aperture")),
                new StudioRow(model, "camera.horizontalAngleDegrees", Texts.get("row.angle")),
                new StudioRow(model, "camera.exposureStops", Texts.get("row.exposure")));
        rows.forEach(row -> row.addTo(panel));
        model.follow(() -> tellVelocity(speed.note()));
    }

    private Range exposures(Studio studio) {
        return size.spans(studio, studio.camera().exposureTime());
    }

    /** Says what the speed is in other notations, or that there are no pictures at this speed. */
    private void tellVelocity(Note note) {
        Velocity now = model.studio().velocity();
        TransformationLaw law = model.studio().transformation();
        String beta = SpeedText.vector(now);
        String numbers = switch (law) {
            case LORENTZ ->
                Texts.get("velocity.numbers", SpeedScale.GAMMA.reading(now), SpeedScale.RAPIDITY.reading(now), beta);
            case GALILEAN -> Texts.get("velocity.beta", beta);
            case NONE -> Texts.get("velocity.ignored", beta);
        };
        law.warning(now).ifPresentOrElse(note::setUsualError, () -> note.setUsual(numbers));
    }
}
