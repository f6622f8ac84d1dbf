package tompkins.property;

import java.lang.reflect.Constructor;
import java.net.URL;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.stream.Collectors;

/**
 * Types that other jars on the class path add to a family, by a non-sealed interface of that family and a file
 * {@code META-INF/services} of its name. They are read once. Nothing is ever loaded because of a scene.
 */
public final class AddedTypes {

    /** Name and version of the jars that add types. */
    private static final Set<String> JARS = new ConcurrentSkipListSet<>();

    private AddedTypes() {}

    /**
     * The records that are added by an interface, in the order of the class path.
     *
     * @throws MistakeException that names the jar, if one of them cannot be used
     */
    static List<Class<?>> of(Class<?> service) {
        List<Class<?>> added = new ArrayList<>();
        try {
            ServiceLoader.load(service, service.getClassLoader()).stream()
                    .forEach(provider -> added.add(provider.type()));
            added.forEach(AddedTypes::check);
            added.forEach(type -> origin(type).ifPresent(JARS::add));
        } catch (ServiceConfigurationError | LinkageError broken) {
            throw new MistakeException(jars(service) + ": " + broken.getMessage());
        }
        return added;
    }

    private static void check(Class<?> type) {
        if (!type.isRecord()) {
            throw mistake(type, "must be a record");
        }
        try {
            Object usual = type.getField("DEFAULT").get(null);
            if (!type.isInstance(usual)) {
                throw mistake(type, "must have a constant DEFAULT of its own type, was " + usual);
            }
            Descriptions.values(usual);
        } catch (ReflectiveOperationException hidden) {
            throw mistake(type, "must be public, with a public constant DEFAULT");
        }
        Constructor<?>[] all = type.getConstructors();
        if (Arrays.stream(all).noneMatch(each -> each.getParameterCount() == type.getRecordComponents().length)) {
            throw mistake(type, "must be public, with the public constructor of its components");
        }
    }

    /**
     * Checks that no two types of some families have one name.
     *
     * @throws MistakeException if two have
     */
    public static void requireDistinct(Class<?>... families) {
        List<Class<?>> all = Arrays.stream(families)
                .flatMap(family -> Descriptions.members(family).stream())
                .toList();
        all.stream().filter(type -> origin(type).isPresent()).forEach(type -> {
            if (all.stream()
                            .filter(other -> other.getSimpleName().equals(type.getSimpleName()))
                            .count()
                    > 1) {
                throw mistake(type, "must have a name of its own: there is another type " + type.getSimpleName());
            }
        });
    }

    /** Name and version of the jars that add types, of those that have been asked for. */
    public static Set<String> jars() {
        return JARS;
    }

    /** Name and version of the jar that adds a type; empty for a type of the program. */
    public static Optional<String> origin(Class<?> type) {
        URL source = type.getProtectionDomain().getCodeSource().getLocation();
        if (source.equals(AddedTypes.class.getProtectionDomain().getCodeSource().getLocation())) {
            return Optional.empty();
        }
        String version = type.getPackage().getImplementationVersion();
        return Optional.of(name(source) + (version == null ? "" : " " + version));
    }

    private static MistakeException mistake(Class<?> type, String problem) {
        return new MistakeException(origin(type).orElse("tompkins") + ": " + type.getName() + " " + problem);
    }

    private static String name(URL source) {
        String path = source.getPath();
        return Path.of(path.endsWith("/") ? path.substring(0, path.length() - 1) : path)
                .getFileName()
                .toString();
    }

    /** The jars that have types for a service. */
    private static String jars(Class<?> service) {
        return service.getClassLoader()
                .resources("META-INF/services/" + service.getName())
                .map(file -> file.getPath().replaceAll("!?/META-INF/.*", ""))
                .map(jar -> jar.substring(jar.lastIndexOf('/') + 1))
                .collect(Collectors.joining(", "));
    }
}
