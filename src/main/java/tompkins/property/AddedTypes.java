package tompkins.property;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.TreeSet;
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
        try {
            List<Class<?>> added = ServiceLoader.load(service, service.getClassLoader()).stream()
                    .<Class<?>>map(ServiceLoader.Provider::type)
                    .toList();
            added.forEach(AddedTypes::check);
            added.forEach(type -> JARS.add(jar(type)));
            return added;
        } catch (ServiceConfigurationError | LinkageError broken) {
            throw new MistakeException(OneLine.of(jars(service, broken.toString()) + ": " + broken));
        }
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
        } catch (ReflectiveOperationException hidden) {
            throw mistake(type, "must be public, with a public constant DEFAULT");
        } catch (LinkageError broken) {
            throw mistake(type, "cannot be loaded: " + (broken.getCause() == null ? broken : broken.getCause()));
        }
    }

    /**
     * Checks that no added type has the name of another member of its family.
     *
     * @throws MistakeException if one has
     */
    static void requireDistinct(List<Class<?>> family) {
        Set<String> names = new TreeSet<>();
        for (Class<?> type : family) {
            if (!names.add(Descriptions.name(type))) {
                throw mistake(type, "must have a name of its own: there is another type " + Descriptions.name(type));
            }
        }
    }

    /** " with optics.jar 2.5": name and version of the jars that have added types; empty if none has. */
    public static String withJars() {
        return JARS.isEmpty() ? "" : " with " + String.join(", ", JARS);
    }

    /** Name and version of the jar of a type. */
    private static String jar(Class<?> type) {
        URL jar = type.getProtectionDomain().getCodeSource().getLocation();
        String version = type.getPackage().getImplementationVersion();
        return OneLine.of(name(jar.toString()) + (version == null ? "" : " " + version));
    }

    private static MistakeException mistake(Class<?> type, String problem) {
        return new MistakeException(OneLine.of(jar(type) + ": " + type.getName() + " " + problem));
    }

    /** The jars that offer, for a service, a type of which a problem tells; all that offer one if it tells of none. */
    private static String jars(Class<?> service, String problem) {
        List<URL> files = service.getClassLoader()
                .resources("META-INF/services/" + service.getName())
                .toList();
        List<URL> told = files.stream().filter(file -> isOf(problem, file)).toList();
        return (told.isEmpty() ? files : told)
                .stream()
                        .map(file -> name(file.toString().replaceAll("^jar:|!?/META-INF/.*", "")))
                        .collect(Collectors.joining(", "));
    }

    private static boolean isOf(String problem, URL file) {
        try (InputStream in = file.openStream()) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .anyMatch(
                            name -> !name.isBlank() && problem.replace('/', '.').contains(name.strip()));
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    private static String name(String jar) {
        return Path.of(URI.create(jar)).getFileName().toString();
    }
}
