package tompkins.ui.widget;

import java.lang.reflect.RecordComponent;
import java.util.Locale;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.sceneobject.Hidden;
import tompkins.sceneobject.SceneObject;

/** The words of the window for types and properties: their names, and their meanings as tooltips. */
public final class Wording {

    private Wording() {}

    /** "apertureRadius" becomes "Aperture radius". */
    public static String label(String name) {
        return Texts.getOr("property." + name, inWords(name));
    }

    /** "AperturePlaneShutter" becomes "Aperture plane shutter". */
    public static String label(Class<?> type) {
        return Texts.getOr("type." + type.getSimpleName(), inWords(type.getSimpleName()));
    }

    /** "ONE_MINUS_BETA" becomes "One minus beta". */
    public static String label(Enum<?> value) {
        String words = value.name().toLowerCase(Locale.ROOT).replace('_', ' ');
        return Texts.getOr("value." + value.name(), capital(words));
    }

    /** The name of an element of a list. */
    public static String nameOf(Object element) {
        if (element instanceof Hidden hidden) {
            return Texts.get("tree.hidden", hidden.description());
        }
        return element instanceof SceneObject object ? object.description() : label(element.getClass());
    }

    /** The meaning of a type, or an empty text. */
    public static String meaning(Class<?> type) {
        Meaning meaning = type.getAnnotation(Meaning.class);
        return meaning == null ? "" : meaning.value();
    }

    /** The meaning of a component with its unit, or an empty text. */
    public static String meaning(RecordComponent component) {
        Meaning meaning = component.getAnnotation(Meaning.class);
        if (meaning == null) {
            return "";
        }
        return meaning.unit().isEmpty() ? meaning.value() : meaning.value() + " (" + unit(meaning.unit()) + ")";
    }

    /** The meaning of a component, found by its name. */
    public static String meaning(Class<?> type, String component) {
        return meaning(Descriptions.component(type, component));
    }

    /** What is wrong with a value: the name of the property as the window calls it, what is allowed, and the value. */
    public static String message(InvalidPropertyException wrong) {
        return label(wrong.property()) + " " + wrong.problem();
    }

    private static String unit(String unit) {
        return unit.equals("length") || unit.equals("time") ? Texts.get("unit." + unit) : unit;
    }

    private static String inWords(String name) {
        StringBuilder words = new StringBuilder();
        for (int i = 0; i < name.length(); i++) {
            char letter = name.charAt(i);
            boolean begins = Character.isUpperCase(letter)
                    && i > 0
                    && (Character.isLowerCase(name.charAt(i - 1))
                            || i + 1 < name.length() && Character.isLowerCase(name.charAt(i + 1)));
            boolean single = begins && (i + 1 == name.length() || Character.isUpperCase(name.charAt(i + 1)));
            if (begins) {
                words.append(' ');
            }
            words.append(begins && !single ? Character.toLowerCase(letter) : letter);
        }
        return capital(words.toString());
    }

    private static String capital(String words) {
        return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }
}
