package tompkins.ui.panel;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import org.joml.Vector3dc;
import tompkins.property.Descriptions;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.SpeedText;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Wording;

/**
 * A number of the studio that an animation can change. Two are equal if they are called the same and stand in the same
 * place.
 *
 * @param name what the user calls it
 * @param path where it stands
 * @param get its value
 * @param with the studio with another value; throws if that is not allowed
 * @param text its value, for reading
 */
public record NumberProperty(
        String name,
        StudioPath path,
        ToDoubleFunction<Studio> get,
        BiFunction<Studio, Double, Studio> with,
        Function<Studio, String> text) {

    /** So many numbers are offered at most; scenes can have millions. */
    private static final int MOST = 500;

    private static final StudioPath VELOCITY = StudioPath.ROOT.then("velocity");

    /** A number that is shown with its first digits. */
    private NumberProperty(
            String name, StudioPath path, ToDoubleFunction<Studio> get, BiFunction<Studio, Double, Studio> with) {
        this(name, path, get, with, studio -> Numbers.brief(get.applyAsDouble(studio)));
    }

    /** The speed on a scale; the direction stays. */
    public static NumberProperty speed(SpeedScale scale) {
        return new NumberProperty(
                Texts.get("scale." + scale.name() + ".name"),
                VELOCITY,
                studio -> scale.valueOf(studio.velocity()),
                (studio, value) -> FrontWindow.withVelocity(
                        studio, Velocity.of(scale, value, studio.velocity().givenDirection())),
                studio -> SpeedText.of(studio.velocity(), scale));
    }

    /** Whether this is the speed, on whatever scale. */
    public boolean isSpeed() {
        return path.equals(VELOCITY);
    }

    /** The time at which the shutter opens. */
    public static NumberProperty openingTime() {
        return new NumberProperty(
                Texts.get("play.openingTime"),
                StudioPath.ROOT.then("camera").then("shutter").then("openingTime"),
                studio -> studio.camera().shutter().openingTime(),
                (studio, value) -> studio.withCamera(
                        studio.camera().withShutter(studio.camera().shutter().openedAt(value))));
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

    /** Whether nothing changed in a studio that could make its numbers others. */
    static boolean unchanged(Studio before, Studio now) {
        return before.camera() == now.camera() && before.hasSameObjects(now);
    }

    private static void collect(Object value, StudioPath path, String name, List<NumberProperty> properties) {
        if (properties.size() >= MOST) {
            return;
        }
        if (value instanceof Double) {
            properties.add(new NumberProperty(name, path, studio -> (Double) path.get(studio), path::with));
        } else if (value instanceof Vector3dc) {
            for (String axis : List.of("x", "y", "z")) {
                StudioPath component = path.then(axis);
                properties.add(new NumberProperty(
                        name + " " + axis, component, studio -> (Double) component.get(studio), component::with));
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
    public boolean equals(Object other) {
        return other instanceof NumberProperty property && name.equals(property.name) && path.equals(property.path);
    }

    @Override
    public int hashCode() {
        return Objects.hash(name, path);
    }

    @Override
    public String toString() {
        return name;
    }
}
