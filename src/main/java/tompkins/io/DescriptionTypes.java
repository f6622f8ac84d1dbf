package tompkins.io;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import tompkins.camera.Camera;
import tompkins.camera.ThinLensCamera;
import tompkins.lesson.Lesson;
import tompkins.lesson.PicturePoint;
import tompkins.light.Pulse;
import tompkins.property.Descriptions;
import tompkins.sceneobject.SceneObject;
import tompkins.studio.Studio;
import tompkins.studio.UniformBackground;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/** What scene files need to know of descriptions: families and the types usual in them, keys, names of constants. */
final class DescriptionTypes {

    /** The members of families that are meant if a scene file does not name a type. */
    private static final Set<Class<?>> USUAL = Set.of(
            ThinLensCamera.class,
            ColouredSurface.class,
            UniformBackground.class,
            Pulse.class,
            Lesson.class,
            PicturePoint.class);

    private static final ClassValue<List<String>> MEMBER_NAMES =
            Descriptions.cachedPerClass(family -> Descriptions.members(family).stream()
                    .<String>map(Descriptions::name)
                    .toList());

    private static final ClassValue<List<String>> KEYS = Descriptions.cachedPerClass(type ->
            Descriptions.components(type).stream().map(RecordComponent::getName).toList());

    private static final ClassValue<Boolean> IS_FAMILY =
            Descriptions.cachedPerClass(type -> type.isInterface() && type.isSealed());

    private static final ClassValue<Optional<Class<?>>> USUAL_MEMBER = Descriptions.cachedPerClass(family ->
            Descriptions.members(family).stream().filter(USUAL::contains).findFirst());

    private DescriptionTypes() {}

    /** Whether a type is a family, whose members have a key {@code type} in scene files. */
    static boolean isFamily(Class<?> type) {
        return IS_FAMILY.get(type);
    }

    /** The names of the records of a family. */
    static List<String> memberNames(Class<?> family) {
        return MEMBER_NAMES.get(family);
    }

    /** The record of a family that is meant where none is named. */
    static Optional<Class<?>> usualMember(Class<?> family) {
        return USUAL_MEMBER.get(family);
    }

    /** The keys of a record. */
    static List<String> keys(Class<?> type) {
        return KEYS.get(type);
    }

    /** The key of a scene, or of a part of it, under which a description of a type belongs. */
    static Optional<String> homeOfType(String name) {
        return Stream.concat(
                        Descriptions.components(Studio.class).stream(),
                        Stream.of(SceneObject.class, Camera.class)
                                .flatMap(family -> Descriptions.members(family).stream())
                                .flatMap(member -> Descriptions.components(member).stream()))
                .filter(component -> family(component)
                        .filter(family -> memberNames(family).contains(name))
                        .isPresent())
                .findFirst()
                .map(RecordComponent::getName);
    }

    private static Optional<Class<?>> family(RecordComponent component) {
        return Descriptions.elementType(component.getGenericType())
                .or(() -> Optional.of(component.getType()))
                .filter(DescriptionTypes::isFamily);
    }

    /** The only other member of the family of a type that has a key. */
    static Optional<String> ownerOfKey(String key, Class<?> type) {
        List<String> owners = Stream.of(SceneObject.class, Surface.class)
                .filter(family -> family.isAssignableFrom(type))
                .flatMap(family -> Descriptions.members(family).stream())
                .filter(member -> keys(member).contains(key))
                .map(Descriptions::name)
                .toList();
        return owners.size() == 1 ? Optional.of(owners.get(0)) : Optional.empty();
    }

    /** The name of a constant in scene files: lower case, with hyphens. */
    static String constantName(Object constant) {
        return ((Enum<?>) constant).name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The names of all constants of an enumeration. */
    static List<String> constantNames(Class<?> type) {
        return Arrays.stream(type.getEnumConstants())
                .map(DescriptionTypes::constantName)
                .toList();
    }
}
