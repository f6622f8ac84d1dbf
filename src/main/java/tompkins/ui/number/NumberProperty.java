package tompkins.ui.number;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3dc;
import tompkins.property.Descriptions;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;
import tompkins.studio.StudioPath;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.SpeedText;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Wording;

/**
 * A number of the studio under the name that the window gives it.
 *
 * @param name what the user calls it
 * @param number where it stands
 */
public record NumberProperty(String name, StudioNumber number) {

    /** The most numbers that are offered; scenes can have millions. */
    private static final int MOST = 500;

    /** The speed on a scale; the direction stays. */
    public static NumberProperty speed(SpeedScale scale) {
        return new NumberProperty(Texts.get("scale." + scale.name() + ".name"), StudioNumber.speed(scale));
    }

    /** Its value in a studio, for reading; a speed as its field shows it, another number with its first digits. */
    public String text(Studio studio) {
        return Stream.of(SpeedScale.values())
                .filter(scale -> number.equals(StudioNumber.speed(scale)))
                .findFirst()
                .map(scale -> SpeedText.of(studio.velocity(), scale))
                .orElseGet(() -> Numbers.brief(number.in(studio)));
    }

    /** The time at which the shutter opens. */
    public static NumberProperty openingTime() {
        return new NumberProperty(Texts.get("play.openingTime"), StudioNumber.OPENING_TIME);
    }

    /** A number of a studio; it is called by its path if it is not among those that are offered. */
    public static NumberProperty of(StudioNumber number, Studio studio) {
        return of(studio).stream()
                .filter(property -> property.number().equals(number))
                .findFirst()
                .orElseGet(() -> new NumberProperty(number.path().toString(), number));
    }

    /**
     * Speed and opening time first, then the other decimal numbers of camera, lights and objects, {@link #MOST} at
     * most.
     */
    static List<NumberProperty> of(Studio studio) {
        List<NumberProperty> properties = new ArrayList<>();
        properties.add(speed(SpeedScale.BETA));
        properties.add(speed(SpeedScale.RAPIDITY));
        if (studio.camera().shutter().hasOpeningTime()) {
            properties.add(openingTime());
        }
        collect(studio.camera(), StudioPath.ROOT.then("camera"), Texts.get("tree.camera"), properties);
        for (String list : List.of("lights", "cameraFrame", "scene")) {
            StudioPath path = StudioPath.ROOT.then(list);
            collect(path.get(studio), path, Wording.label(list), properties);
        }
        return properties;
    }

    /** Whether nothing has changed in a studio that could change which numbers it has. */
    static boolean unchanged(Studio before, Studio now) {
        return before.camera() == now.camera() && before.hasSameObjects(now);
    }

    private static void collect(Object value, StudioPath path, String name, List<NumberProperty> properties) {
        if (properties.size() >= MOST) {
            return;
        }
        if (value instanceof Double) {
            StudioNumber number = new StudioNumber(path);
            if (!number.equals(StudioNumber.OPENING_TIME)) {
                properties.add(new NumberProperty(name, number));
            }
        } else if (value instanceof Velocity) {
            properties.add(new NumberProperty(name, new StudioNumber(path.then(SpeedScale.BETA.key()))));
        } else if (value instanceof Vector3dc) {
            for (String axis : StudioPath.stepsFrom(value)) {
                properties.add(new NumberProperty(name + " " + axis, new StudioNumber(path.then(axis))));
            }
        } else if (value instanceof List<?> list) {
            for (int i = 0; i < list.size() && properties.size() < MOST; i++) {
                collect(list.get(i), path.then(i), name + " \u203a " + Wording.nameOf(list.get(i)), properties);
            }
        } else if (value instanceof Record) {
            for (RecordComponent component : Descriptions.components(value.getClass())) {
                String label = name + " \u203a " + Wording.label(component.getName());
                collect(Descriptions.value(component, value), path.then(component.getName()), label, properties);
            }
        }
    }

    @Override
    public String toString() {
        return name;
    }
}
