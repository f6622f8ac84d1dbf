package tompkins.ui;

import java.util.function.IntUnaryOperator;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import tompkins.animation.Animation;
import tompkins.property.Require;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberField;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** Asks how many pictures a second an animation should have, and how large they should be. */
final class AnimationOptions {

    private final JPanel panel = Rows.of("wrap 2, hidemode 3, gap 8 5", "[][grow,fill]");
    private final Note refused = Note.ofLines(3);
    private final Note count = Note.ofLines(2);
    private final NumberField rate = field("frameRate", this::setRate);
    private final NumberField width = field("width", pixels -> setSize("width", pixels, own().width()));
    private final NumberField height = field("height", pixels -> setSize("height", pixels, own().height()));
    private final RenderSettings own;
    private Studio studio;
    private final IntUnaryOperator frames;
    private int frameRate = Animation.FRAME_RATE;

    /** Takes a whole number, or refuses it. */
    private interface Taker {
        void take(int number);
    }

    /** Proposes an animation in the size of a studio; {@code frames} says how many pictures a rate needs. */
    AnimationOptions(Studio studio, IntUnaryOperator frames) {
        this.studio = studio;
        this.frames = frames;
        own = studio.settings();
        panel.setBorder(BorderFactory.createEmptyBorder(0, 12, 0, 0));
        add("frameRate", rate);
        add("width", width);
        add("height", height);
        panel.add(count.component(), "span, growx, w 160");
        panel.add(refused.component(), "span, growx, w 160");
        update();
    }

    private NumberField field(String key, Taker taker) {
        String name = Texts.get("export." + key);
        return new NumberField(
                NumberKind.INT,
                key,
                name,
                Texts.get("export." + key + "Tip"),
                refused,
                number -> taker.take(number.intValue()));
    }

    private void add(String key, NumberField field) {
        JLabel label = new JLabel(Texts.get("export." + key));
        label.setLabelFor(field.field());
        panel.add(label);
        panel.add(field.field());
    }

    private void setRate(int picturesASecond) {
        frameRate = Require.within("frameRate", picturesASecond, 1, Animation.HIGHEST_FRAME_RATE);
        update();
    }

    /** Takes a width or a height; the pictures keep their proportions. */
    private void setSize(String side, int pixels, int ownPixels) {
        Require.within(side, pixels, 1, RenderSettings.LONGEST_SIDE);
        double scale = (double) pixels / ownPixels;
        studio = studio.withSettings(own.withSize(scaled(own.width(), scale), scaled(own.height(), scale)));
        update();
    }

    private RenderSettings own() {
        return own;
    }

    private static int scaled(int pixels, double scale) {
        return Math.max(1, (int) Math.round(pixels * scale));
    }

    private void update() {
        RenderSettings size = studio.settings();
        rate.show(frameRate);
        width.show(size.width());
        height.show(size.height());
        count.setText(Texts.get("export.count", frames.applyAsInt(frameRate), size.width(), size.height()));
    }

    /** The fields, to be put into a dialog. */
    JComponent component() {
        return panel;
    }

    /** The studio with the size that was asked for. */
    Studio studio() {
        return studio;
    }

    /** The pictures a second that were asked for. */
    int frameRate() {
        return frameRate;
    }
}
