package tompkins.ui;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import tompkins.animation.StudioNumber;
import tompkins.light.ColourLaw;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.studio.Studio;
import tompkins.ui.panel.NumberProperty;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.SpeedText;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Wording;

/** What pictures say about themselves: how fast the camera is, by which laws, and the number that is animated. */
public final class Captions {

    private static final String SETTING = "caption";

    private final PictureCanvas canvas;
    private final Settings settings;
    private NumberProperty animated;

    /** Captions on a canvas, if the settings say so. */
    Captions(PictureCanvas canvas, Settings settings) {
        this.canvas = canvas;
        this.settings = settings;
        update();
    }

    /** Whether pictures have captions. */
    boolean areShown() {
        return settings.number(SETTING, 0) != 0;
    }

    /** Gives pictures captions from now on, or none. */
    void setShown(boolean shown) {
        settings.setNumber(SETTING, shown ? 1 : 0);
        settings.save();
        update();
    }

    /** Tells of another number from now on; of none if it is null. */
    void setAnimated(NumberProperty number) {
        animated = number;
        update();
    }

    private void update() {
        canvas.setCaptions(areShown() ? this::of : null);
    }

    /** The caption of a picture now. */
    String of(Studio studio) {
        return of(studio, animated);
    }

    /** Writes the captions of the pictures of an animation; empty ones, if none are wanted. */
    public static Function<Studio, String> ofPictures(Studio studio, StudioNumber animated, boolean wanted) {
        NumberProperty number = NumberProperty.of(animated, studio);
        return moment -> wanted ? of(moment, number) : "";
    }

    /** The caption of a picture with a number besides its speed, or with none if it is null. */
    static String of(Studio studio, NumberProperty number) {
        List<String> words = new ArrayList<>();
        words.add(motion(studio));
        // another shutter may have no opening time
        if (number != null && !number.number().isSpeed() && number.number().isIn(studio)) {
            words.add(Texts.get("caption.number", number.name(), number.text().apply(studio)));
        }
        return String.join(", ", words);
    }

    /** The speed, and the laws if they are not the usual ones: {@code beta = 0.97, gamma = 4.113}. */
    static String motion(Studio studio) {
        List<String> words = new ArrayList<>();
        words.add(Texts.get("caption.beta", SpeedText.of(studio.velocity(), SpeedScale.BETA)));
        if (studio.transformation() == TransformationLaw.LORENTZ) {
            words.add(Texts.get("caption.gamma", SpeedScale.GAMMA.reading(studio.velocity())));
        } else {
            words.add(Texts.get("caption." + studio.transformation()));
        }
        if (studio.colours() != ColourLaw.UNCHANGED) {
            words.add(Wording.label(studio.colours()));
        }
        return String.join(", ", words);
    }
}
