package tompkins.ui.photograph;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import tompkins.animation.FrameSequence;
import tompkins.animation.RideFilm;
import tompkins.light.ColourLaw;
import tompkins.property.NumberText;
import tompkins.sceneobject.Moving;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.RideMoment;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;
import tompkins.studio.View;
import tompkins.ui.model.Settings;
import tompkins.ui.number.NumberProperty;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.SpeedText;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Wording;

/** What pictures say about themselves: how fast the camera is, by which laws, and the number that is animated. */
public final class Captions {

    private static final String SETTING = "caption";

    /** From this speed on, digits count the difference from the speed of light. */
    private static final double FAST = 0.9;

    /** More objects that move are only counted. */
    private static final int MOST_OBJECTS = 2;

    private final PictureCanvas canvas;
    private final Settings settings;
    private final boolean usual;
    private NumberProperty animated;
    private BooleanSupplier ridden = () -> false;

    /** Captions on a canvas, if the settings say so; {@code usual} counts if they say nothing. */
    public Captions(PictureCanvas canvas, Settings settings, boolean usual) {
        this.canvas = canvas;
        this.settings = settings;
        this.usual = usual;
        update();
    }

    /** Whether pictures have captions. */
    public boolean areShown() {
        return settings.number(SETTING, usual ? 1 : 0) != 0;
    }

    /** Shows captions from now on, or hides them. */
    public void setShown(boolean shown) {
        settings.setNumber(SETTING, shown ? 1 : 0);
        update();
    }

    /** Names another number from now on; none if it is null. */
    public void setAnimated(NumberProperty number) {
        animated = number;
        update();
    }

    /** Asks from now on whether the line of a ride says how fast the camera is: the picture is a little late. */
    public void setRidden(BooleanSupplier line) {
        ridden = line;
    }

    private void update() {
        canvas.setCaptions(this::onScreen);
    }

    /** What is written into a picture on the screen: as {@link #shown}, without what the line of a ride says. */
    String onScreen(Studio studio) {
        return ridden.getAsBoolean() ? view(studio) : shown(studio);
    }

    /**
     * What is written into a picture now: its caption, or if none is wanted, a note if it is not a photograph;
     * otherwise nothing.
     */
    public String shown(Studio studio) {
        return areShown() ? of(studio, animated) : view(studio);
    }

    /** Says of a picture that it is not a photograph; empty if it is one. */
    private static String view(Studio studio) {
        return studio.view() == View.MEASURED ? Texts.get("caption.MEASURED") : "";
    }

    /** Writes the captions of the pictures of an animation; if none are wanted, only says what is not a photograph. */
    public static FrameSequence.Caption ofPictures(Studio studio, StudioNumber animated, boolean wanted) {
        NumberProperty number = NumberProperty.of(animated, studio);
        return (moment, frame) -> wanted ? of(moment, number) : view(moment);
    }

    /** Writes the captions of the pictures of a ride; if none are wanted, only says what is not a photograph. */
    public static FrameSequence.Caption ofPictures(RideFilm film, boolean wanted) {
        return (moment, frame) ->
                wanted ? of(film.moment(frame), true) : view(film.moment(frame).studio());
    }

    /**
     * The caption of a moment of a ride: the motion, and the time on board and in the scene since its beginning.
     *
     * @param goesOn whether the speed has no more digits than can be read while they change
     */
    public static String of(RideMoment moment, boolean goesOn) {
        return joined(moment.studio(), parts(moment, goesOn));
    }

    /** The parts of that caption, without a note that the picture is no photograph. */
    public static List<String> parts(RideMoment moment, boolean goesOn) {
        Studio studio = moment.studio();
        return List.of(
                String.join(", ", words(studio, goesOn ? brief(studio.velocity()) : studio.velocity())),
                Texts.get("caption.ride", tenths(moment.properTime()), tenths(moment.sceneTime())));
    }

    /** What moves in the scene frame, each with its speed; of many only those that do not stand still, or how many. */
    private static List<String> objects(Studio studio) {
        List<String> all = objects(studio, object -> true);
        List<String> told = all.size() > MOST_OBJECTS
                ? objects(studio, object -> !object.velocity().isRest())
                : all;
        return told.size() > MOST_OBJECTS ? List.of(Texts.get("caption.many", told.size())) : told;
    }

    private static List<String> objects(Studio studio, Predicate<Moving> wanted) {
        return studio.scene().stream()
                .filter(Moving.class::isInstance)
                .map(Moving.class::cast)
                .filter(wanted)
                .map(object -> Texts.get(
                        "caption.object", object.description(), SpeedText.of(object.velocity(), SpeedScale.BETA)))
                .distinct()
                .toList();
    }

    private static Velocity brief(Velocity exact) {
        return exact.speed() < FAST
                ? Velocity.of(SpeedScale.BETA, Math.rint(exact.speed() * 1e3) / 1e3, exact.givenDirection())
                : Velocity.of(
                        SpeedScale.ONE_MINUS_BETA,
                        NumberText.rounded(exact.oneMinusSpeed(), 2),
                        exact.givenDirection());
    }

    private static String tenths(double time) {
        return String.format(Locale.ROOT, "%.1f", time);
    }

    /** The caption of a picture with a number besides its speed, or with none if it is null. */
    static String of(Studio studio, NumberProperty number) {
        List<String> words = new ArrayList<>();
        // another shutter may have no opening time
        if (number != null && !number.number().isSpeed() && number.number().isIn(studio)) {
            words.add(Texts.get("caption.number", number.name(), number.text(studio)));
        }
        words.add(motion(studio));
        return String.join(", ", words);
    }

    /**
     * The speed, and the view and the laws if they are not the usual ones: {@code beta = 0.97, gamma = 4.113}. Where
     * objects move, too, it says which speed is that of the camera.
     */
    static String motion(Studio studio) {
        return joined(studio, words(studio, studio.velocity()));
    }

    private static String joined(Studio studio, List<String> words) {
        List<String> all = new ArrayList<>(words);
        if (studio.view() == View.MEASURED) {
            all.add(0, view(studio));
        }
        return String.join(", ", all);
    }

    /**
     * The speed and the laws, with fewer digits of the speed if the velocity has fewer; gamma is that of the studio.
     */
    private static List<String> words(Studio studio, Velocity velocity) {
        List<String> words = new ArrayList<>();
        List<String> objects = objects(studio);
        boolean told = objects.isEmpty() || !velocity.isRest();
        if (told) {
            String beta = Texts.get("caption.beta", SpeedText.of(velocity, SpeedScale.BETA));
            words.add(objects.isEmpty() ? beta : Texts.get("caption.camera", beta));
        } else {
            words.add(Texts.get("caption.rests"));
        }
        if (studio.transformation() != TransformationLaw.LORENTZ) {
            words.add(Texts.get("caption." + studio.transformation()));
        } else if (told) {
            words.add(Texts.get("caption.gamma", SpeedScale.GAMMA.reading(studio.velocity())));
        }
        words.addAll(objects);
        if (studio.colours() != ColourLaw.UNCHANGED
                && studio.view() == View.SEEN
                && studio.transformation() == TransformationLaw.LORENTZ) {
            words.add(Wording.label(studio.colours()));
        }
        return words;
    }
}
