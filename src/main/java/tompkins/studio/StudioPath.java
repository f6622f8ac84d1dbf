package tompkins.studio;

import java.lang.reflect.RecordComponent;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Described;
import tompkins.property.Descriptions;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;

/**
 * The way to a part of a studio: names of components, places in lists, x, y, z in vectors, and in velocities the speed
 * on a {@link SpeedScale} by its {@link SpeedScale#key}.
 *
 * @param steps names (String) and places (Integer), from the studio to the part
 */
public record StudioPath(List<Object> steps) {

    private static final String AXES = "xyz";

    /** A name, with a point before it unless it is the first step, or a place in a list. */
    private static final Pattern STEP =
            Pattern.compile("(?:^|(?<=[A-Za-z\\]])\\.)(\\$?[A-Za-z]+)|(?<=[A-Za-z\\]])\\[([0-9]{1,9})\\]");

    /** The studio itself. */
    public static final StudioPath ROOT = new StudioPath(List.of());

    /** Keeps a copy of the steps. */
    public StudioPath {
        steps = List.copyOf(steps);
    }

    /**
     * The way to an object of a studio, to that very one and not to an equal one; empty if the studio does not hold it.
     */
    public static Optional<StudioPath> to(Studio studio, Described object) {
        Deque<Object> steps = new ArrayDeque<>();
        return lead(studio, object, steps) ? Optional.of(new StudioPath(List.copyOf(steps))) : Optional.empty();
    }

    /** Whether a part of a studio holds an object; puts the steps to it before others. */
    private static boolean lead(Object part, Described wanted, Deque<Object> steps) {
        boolean mayHold = part instanceof Studio || part instanceof List || part instanceof SceneObject;
        List<?> inner = mayHold ? Descriptions.parts(part) : List.of();
        for (int i = 0; i < inner.size(); i++) {
            if (inner.get(i) == wanted || lead(inner.get(i), wanted, steps)) {
                steps.addFirst(
                        part instanceof List
                                ? i
                                : Descriptions.components(part.getClass())
                                        .get(i)
                                        .getName());
                return true;
            }
        }
        return false;
    }

    /**
     * The way that a text describes in the form that messages use, such as {@code scene[0].centre.x}; empty if it is
     * not a way. It need not lead to anything.
     */
    public static Optional<StudioPath> parse(String text) {
        // step by step: a pattern of all steps would need a stack that grows with them
        List<Object> steps = new ArrayList<>();
        Matcher step = STEP.matcher(text);
        int end = 0;
        while (step.find() && step.start() == end) {
            steps.add(step.group(1) == null ? (Object) Integer.valueOf(step.group(2)) : step.group(1));
            end = step.end();
        }
        return steps.isEmpty() || end < text.length() ? Optional.empty() : Optional.of(new StudioPath(steps));
    }

    /** The way in the form that messages use, such as {@code scene[0].centre.x}. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder();
        for (Object step : steps) {
            text.append(step instanceof Integer ? "[" + step + "]" : (text.isEmpty() ? "" : ".") + step);
        }
        return text.toString();
    }

    /** The way to a part of this part. */
    public StudioPath then(Object step) {
        List<Object> longer = new ArrayList<>(steps);
        longer.add(step);
        return new StudioPath(longer);
    }

    /** The way to what this is a part of. */
    public StudioPath parent() {
        return new StudioPath(steps.subList(0, steps.size() - 1));
    }

    /** Whether this leads to a part of another part, or to that itself. */
    public boolean isWithin(StudioPath other) {
        return other.steps.size() <= steps.size() && other.steps.equals(steps.subList(0, other.steps.size()));
    }

    /** The last step. */
    public Object last() {
        return steps.get(steps.size() - 1);
    }

    /**
     * The way to the same part in a whole that has changed, even if it now has another place in a list. If its list has
     * lost the part, the way leads to the part before it; if the way now ends earlier, it leads to its end.
     */
    public StudioPath followed(Object before, Object now) {
        StudioPath path = ROOT;
        Object old = before;
        Object part = now;
        for (Object step : steps) {
            if (!leadsOn(part, step)) {
                return path;
            }
            Object next = step instanceof Integer place ? place((List<?>) old, place, (List<?>) part) : step;
            path = path.then(next);
            old = step(old, step);
            part = step(part, next);
        }
        return path;
    }

    private static boolean leadsOn(Object part, Object step) {
        return part instanceof List<?> list
                ? step instanceof Integer && !list.isEmpty()
                : part instanceof Record
                        && step instanceof String name
                        && Descriptions.find(part.getClass(), name).isPresent();
    }

    private static int place(List<?> before, int place, List<?> now) {
        Object part = before.get(place);
        if (place < now.size() && now.get(place) == part) {
            return place;
        }
        for (int i = 0; i < now.size(); i++) {
            if (now.get(i) == part) {
                return i;
            }
        }
        int neighbour = now.size() < before.size() ? place - 1 : place;
        return Math.max(0, Math.min(neighbour, now.size() - 1));
    }

    /** The steps that lead on from a part: names, or {@code [0] to [4]} in a list; empty if it has no parts. */
    public static List<String> stepsFrom(Object part) {
        if (part instanceof List<?> list) {
            return list.isEmpty()
                    ? List.of()
                    : List.of(list.size() == 1 ? "[0]" : "[0] to [" + (list.size() - 1) + "]");
        }
        if (part instanceof Vector3dc) {
            return List.of(AXES.split(""));
        }
        if (part instanceof Velocity) {
            return Stream.of(SpeedScale.values()).map(SpeedScale::key).toList();
        }
        return part instanceof Record
                ? Descriptions.components(part.getClass()).stream()
                        .map(RecordComponent::getName)
                        .toList()
                : List.of();
    }

    /** How many steps of this way exist in a whole: all of them if it leads to a part. */
    public int length(Object whole) {
        Object part = whole;
        for (int i = 0; i < steps.size(); i++) {
            Object step = steps.get(i);
            boolean exists = part instanceof List<?> list
                    ? step instanceof Integer place && place < list.size()
                    : stepsFrom(part).contains(step);
            if (!exists) {
                return i;
            }
            part = step(part, step);
        }
        return steps.size();
    }

    /** The part of a whole. */
    public Object get(Object whole) {
        Object part = whole;
        for (Object step : steps) {
            part = step(part, step);
        }
        return part;
    }

    private static Object step(Object part, Object step) {
        if (part instanceof List<?> list) {
            return list.get((Integer) step);
        }
        if (part instanceof Vector3dc vector) {
            return vector.get(AXES.indexOf((String) step));
        }
        if (part instanceof Velocity velocity) {
            return scale(step).valueOf(velocity);
        }
        return Descriptions.value(Descriptions.component(part.getClass(), (String) step), part);
    }

    private static SpeedScale scale(Object key) {
        return Stream.of(SpeedScale.values())
                .filter(scale -> scale.key().equals(key))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("there is no speed scale " + key));
    }

    /**
     * The whole with another part.
     *
     * @throws tompkins.property.InvalidPropertyException if a record on the way does not accept it
     */
    public <R> R with(R whole, Object part) {
        @SuppressWarnings("unchecked")
        R changed = (R) with(whole, steps, part);
        return changed;
    }

    private static Object with(Object whole, List<Object> steps, Object part) {
        if (steps.isEmpty()) {
            return part;
        }
        Object step = steps.get(0);
        Object changed = with(step(whole, step), steps.subList(1, steps.size()), part);
        if (whole instanceof List<?> list) {
            List<Object> copy = new ArrayList<>(list);
            copy.set((Integer) step, changed);
            return copy;
        }
        if (whole instanceof Vector3dc vector) {
            return new Vector3d(vector).setComponent(AXES.indexOf((String) step), (Double) changed);
        }
        if (whole instanceof Velocity velocity) {
            return Velocity.of(scale(step), (Double) changed, velocity.givenDirection());
        }
        return Descriptions.with(whole, (String) step, changed);
    }
}
