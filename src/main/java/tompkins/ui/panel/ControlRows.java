package tompkins.ui.panel;

import java.util.List;
import java.util.function.Function;
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

    /** Has room for what may be wrong. */
    private final Note speedNote = Note.ofLines(3);

    /** The rows for a model, which follow its studio. */
    public ControlRows(StudioModel model) {
        super(Rows.of("wrap 2, hidemode 3, gap 6 5", "[pref!][grow,fill]"));
        this.model = model;
        List<StudioRow> rows = List.of(
                row("velocity.beta", "speed.name", speedNote, studio -> Range.speeds(FASTEST)),
                row("colours", "row.colours"),
                row("view", "row.view"),
                row("camera.shutter", "row.shutter"),
                row("camera.shutter.openingTime", "row.openingTime", new Note(""), size::times),
                row(
                        "camera.exposureTime",
                        "row.exposureTime",
                        new Note(""),
                        studio -> size.spans(studio, studio.camera().exposureTime())),
                row("camera.apertureRadius", "row.aperture"),
                row("camera.horizontalAngleDegrees", "row.angle"),
                row("camera.exposureStops", "row.exposure"));
        rows.forEach(row -> row.addTo(panel));
        model.follow(this::tellVelocity);
    }

    private StudioRow row(String path, String name) {
        return new StudioRow(model, path, Texts.get(name));
    }

    private StudioRow row(String path, String name, Note note, Function<Studio, Range> range) {
        return new StudioRow(model, path, Texts.get(name), note, range);
    }

    /** Says what the speed is in other notations, or that there are no pictures at this speed. */
    private void tellVelocity() {
        Velocity now = model.studio().velocity();
        TransformationLaw law = model.studio().transformation();
        String beta = SpeedText.vector(now);
        String numbers = switch (law) {
            case LORENTZ ->
                Texts.get("velocity.numbers", SpeedScale.GAMMA.reading(now), SpeedScale.RAPIDITY.reading(now), beta);
            case GALILEAN -> Texts.get("velocity.beta", beta);
            case NONE -> Texts.get("velocity.ignored", beta);
        };
        law.warning(now).ifPresentOrElse(speedNote::setUsualError, () -> speedNote.setUsual(numbers));
    }
}
