package tompkins.ui.animate;

import java.util.function.IntUnaryOperator;
import javax.swing.BorderFactory;
import tompkins.animation.Animation;
import tompkins.image.AnimationFormat;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.ui.exchange.PictureSize;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberField;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** Asks how many pictures a second an animation should have, and how large they should be. */
final class AnimationOptions extends Part {

    private final Note refused = Note.ofLines(3);
    private final Note count = Note.ofLines(2);
    private final NumberField rate = NumberField.within(
            "frameRate",
            1,
            AnimationFormat.FASTEST,
            Texts.get("export.frameRate"),
            Texts.get("export.frameRateTip"),
            refused,
            this::setRate);
    private final PictureSize size;
    private final IntUnaryOperator frames;
    private int frameRate = Animation.FRAME_RATE;

    /** Proposes an animation in the size of a studio; {@code frames} says how many pictures a rate needs. */
    AnimationOptions(Studio studio, IntUnaryOperator frames) {
        super(Rows.of("wrap 2, hidemode 3, gap 8 5", "[][grow,fill]"));
        this.frames = frames;
        size = new PictureSize(studio, refused, this::update);
        panel.setBorder(BorderFactory.createEmptyBorder(0, 12, 0, 0));
        Rows.add(panel, Texts.get("export.frameRate"), rate.field(), "");
        size.addTo(panel);
        panel.add(count.component(), "span, growx, w 160");
        panel.add(refused.component(), "span, growx, w 160");
        update();
    }

    private void setRate(int picturesASecond) {
        frameRate = picturesASecond;
        update();
    }

    private void update() {
        RenderSettings now = studio().settings();
        rate.show(frameRate);
        count.setText(Texts.get("export.count", frames.applyAsInt(frameRate), now.width(), now.height()));
    }

    /** The studio with the size that was asked for. */
    Studio studio() {
        return size.studio();
    }

    /** The pictures a second that were asked for. */
    int frameRate() {
        return frameRate;
    }
}
