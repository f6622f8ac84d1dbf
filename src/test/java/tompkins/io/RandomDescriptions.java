package tompkins.io;

import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.joml.Vector2i;
import org.joml.Vector2ic;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector3i;
import org.joml.Vector3ic;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Colour;
import tompkins.ray.MeshData;
import tompkins.ray.PixelPicture;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;

/** Makes descriptions with random values that their constructors accept; the same seed makes the same ones. */
final class RandomDescriptions {

    private static final int DEEPEST = 3;
    private static final String LETTERS = "abc XYZ 0189 \"\\/\t\n\u0000\u2028\u03b2\u00fc{}[],:";

    private final SplittableRandom random;
    private final List<PixelPicture> pictures;

    /** A source of descriptions that use some of these pictures. */
    RandomDescriptions(long seed, List<PixelPicture> pictures) {
        random = new SplittableRandom(seed);
        this.pictures = pictures;
    }

    /** A record of a type. */
    Object record(Class<?> type) {
        return record(type, 0);
    }

    private Object record(Class<?> type, int depth) {
        RecordComponent[] components = type.getRecordComponents();
        Object[] values = new Object[components.length];
        for (int attempt = 0; attempt < 100_000; attempt++) {
            for (int i = 0; i < components.length; i++) {
                // what holds other descriptions is expensive, and seldom the reason for a refusal
                values[i] = attempt % 20 != 0 && isNested(components[i]) ? values[i] : value(components[i], depth);
            }
            try {
                return Descriptions.make(type, values);
            } catch (InvalidPropertyException refused) {
                // the next attempt is another one
            }
        }
        throw new AssertionError("no valid " + type + " found");
    }

    private static boolean isNested(RecordComponent component) {
        return component.getType() == List.class || DescriptionTypes.isFamily(component.getType());
    }

    private Object value(RecordComponent component, int depth) {
        Optional<Class<?>> element = Descriptions.elementType(component.getGenericType());
        if (element.isPresent()) {
            int length = depth < DEEPEST ? random.nextInt(3) : 0;
            return Stream.generate(() -> value(element.get(), depth + 1))
                    .limit(length)
                    .toList();
        }
        return value(component.getType(), depth);
    }

    private Object value(Type type, int depth) {
        if (type instanceof Class<?> family && DescriptionTypes.isFamily(family)) {
            List<Class<?>> members = Descriptions.members(family);
            Class<?> member = members.get(random.nextInt(members.size()));
            return depth < DEEPEST ? record(member, depth + 1) : Descriptions.standard(members.get(0));
        }
        if (type instanceof Class<?> constants && constants.isEnum()) {
            return constants.getEnumConstants()[random.nextInt(constants.getEnumConstants().length)];
        }
        if (type == double.class) {
            return number();
        }
        if (type == int.class) {
            return (int) Math.pow(2, 17 * random.nextDouble());
        }
        if (type == long.class) {
            return random.nextLong();
        }
        if (type == boolean.class) {
            return random.nextBoolean();
        }
        if (type == String.class) {
            return text();
        }
        if (type == Vector3dc.class) {
            return vector();
        }
        if (type == Vector3ic.class) {
            return new Vector3i(random.nextInt(40), random.nextInt(40), random.nextInt(40));
        }
        if (type == Vector2ic.class) {
            return new Vector2i(random.nextInt(40), random.nextInt(40));
        }
        if (type == Colour.class) {
            return random.nextBoolean()
                    ? Colour.grey(random.nextDouble())
                    : new Colour(random.nextDouble(), Math.abs(number()), 0);
        }
        if (type == Velocity.class) {
            return velocity();
        }
        if (type == PixelPicture.class) {
            return pictures.get(random.nextInt(pictures.size()));
        }
        if (type == MeshData.class) {
            return MeshData.OCTAHEDRON;
        }
        return record((Class<?>) type, depth + 1);
    }

    /** Any size from 1e-300 to 1e300, but often a moderate one; all digits; also both zeros. */
    private double number() {
        int kind = random.nextInt(10);
        double sign = random.nextBoolean() ? 1 : -1;
        return switch (kind) {
            case 0 -> sign * 0.0;
            case 1 -> sign * Math.pow(10, 600 * random.nextDouble() - 300);
            case 2 -> sign * random.nextInt(100);
            default -> sign * Math.pow(10, 6 * random.nextDouble() - 3);
        };
    }

    private Vector3d vector() {
        return new Vector3d(number(), number(), number());
    }

    private Velocity velocity() {
        if (random.nextInt(3) == 0) {
            return Velocity.of(
                    1.1 * random.nextDouble() - 0.55, 1.1 * random.nextDouble() - 0.55, random.nextDouble() - 0.5);
        }
        Vector3d direction = new Vector3d(random.nextDouble(), number(), -1);
        return switch (random.nextInt(4)) {
            case 0 -> Velocity.of(SpeedScale.BETA, random.nextDouble(), direction);
            case 1 -> Velocity.of(SpeedScale.GAMMA, Math.pow(10, 7.9 * random.nextDouble()), direction);
            case 2 -> Velocity.of(SpeedScale.RAPIDITY, 18 * random.nextDouble(), direction);
            default -> Velocity.of(SpeedScale.ONE_MINUS_BETA, Math.pow(10, -16 * random.nextDouble()), direction);
        };
    }

    private String text() {
        StringBuilder text = new StringBuilder();
        int length = random.nextInt(20);
        for (int i = 0; i < length; i++) {
            text.append(LETTERS.charAt(random.nextInt(LETTERS.length())));
        }
        return text.toString();
    }
}
