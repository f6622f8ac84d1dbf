package tompkins.app;

import java.util.Iterator;
import java.util.Locale;
import java.util.stream.Stream;
import tompkins.image.PictureFormat;
import tompkins.image.ToneCurve;
import tompkins.light.ColourLaw;
import tompkins.light.Metering;
import tompkins.shutter.SweepDirection;
import tompkins.studio.View;

/** The words that an option takes for the values of an enum, as they are typed, in small letters. */
abstract class OptionWords implements Iterable<String> {

    private final Enum<?>[] values;

    OptionWords(Enum<?>... values) {
        this.values = values;
    }

    /** The word for a value. */
    static String of(Enum<?> value) {
        return value.name().toLowerCase(Locale.ROOT);
    }

    @Override
    public Iterator<String> iterator() {
        return Stream.of(values).map(OptionWords::of).iterator();
    }

    /** The words of {@code --format}. */
    static final class Formats extends OptionWords {

        Formats() {
            super(PictureFormat.values());
        }
    }

    /** The words of {@code --tone}. */
    static final class ToneCurves extends OptionWords {

        ToneCurves() {
            super(ToneCurve.values());
        }
    }

    /** The words of {@code --rolling}. */
    static final class SweepDirections extends OptionWords {

        SweepDirections() {
            super(SweepDirection.values());
        }
    }

    /** The words of {@code --metering}. */
    static final class Meterings extends OptionWords {

        Meterings() {
            super(Metering.values());
        }
    }

    /** The words of {@code --view}. */
    static final class Views extends OptionWords {

        Views() {
            super(View.values());
        }
    }

    /** The words of {@code --colours}. */
    static final class ColourLaws extends OptionWords {

        ColourLaws() {
            super(ColourLaw.values());
        }
    }
}
