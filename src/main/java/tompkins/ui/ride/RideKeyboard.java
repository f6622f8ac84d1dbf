package tompkins.ui.ride;

import java.awt.event.KeyEvent;
import java.awt.im.InputContext;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import tompkins.ui.widget.LatinKeys;
import tompkins.ui.widget.Texts;

/**
 * A keyboard, by the letters that lie where an American one has W, A, S, D, Q, E and B: a ride is steered by places
 * under the fingers, and Java tells letters.
 *
 * @param name what it is called
 * @param letters seven small letters, in that order
 */
public record RideKeyboard(String name, String letters) {

    /** The command of the last letter; those before are the directions of thrust. */
    static final int BRAKE = 6;

    /** The languages and countries of which most keyboards have A where others have Q. */
    private static final Set<String> AZERTY = Set.of("fr_FR", "fr_BE", "nl_BE", "fr");

    /** The common keyboards, the most common first. */
    static List<RideKeyboard> common() {
        return Texts.get("ride.keyboards")
                .lines()
                .map(line -> line.split("\t"))
                .map(parts -> new RideKeyboard(parts[1], parts[0]))
                .toList();
    }

    /** The keyboard that is used now, as far as the system tells. */
    static RideKeyboard usual() {
        return usual(InputContext.getInstance().getLocale());
    }

    /** The keyboard of a language, which may be null. */
    static RideKeyboard usual(Locale locale) {
        boolean azerty = locale != null
                && AZERTY.contains(
                        locale.getLanguage() + (locale.getCountry().isEmpty() ? "" : "_" + locale.getCountry()));
        return common().get(azerty ? 1 : 0);
    }

    /** The common keyboard with some letters; the usual one if there is none. */
    static RideKeyboard of(String letters) {
        return common().stream()
                .filter(keyboard -> keyboard.letters.equals(letters))
                .findFirst()
                .orElseGet(RideKeyboard::usual);
    }

    /** The letters as they stand on keys, with spaces between them. */
    String text() {
        // letter by letter: a whole word may end with a letter of its own
        return letters.chars()
                // of two small letters with one capital the second stays small
                .map(c -> Character.toLowerCase(Character.toUpperCase(c)) == c ? Character.toUpperCase(c) : c)
                .mapToObj(Character::toString)
                .collect(Collectors.joining(" "));
    }

    /**
     * What a letter means: 0 to 5 thrust to the place of W, A, S, D, Q or E, {@link #BRAKE} to brake; -1 nothing. A
     * letter of another script means what it does on an American keyboard, in its place.
     */
    int command(char letter) {
        int here = letters.indexOf(Character.toLowerCase(letter));
        int place = LatinKeys.code(letter);
        return here >= 0 || place == KeyEvent.VK_UNDEFINED
                ? here
                : common().get(0).letters.indexOf(Character.toLowerCase(place));
    }
}
