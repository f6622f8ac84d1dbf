package tompkins;

import static com.tngtech.archunit.core.domain.JavaCall.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.name;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.AccessTarget.CodeUnitAccessTarget;
import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.syntax.elements.GivenClassesConjunction;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.GenericArrayType;
import java.lang.reflect.Modifier;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.lang.reflect.WildcardType;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.ThreadFactory;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** Holds what the design promises about packages, names, state and size, over all classes and source files. */
class ArchitectureTest {

    /** In order: a package may use those before it, never those after it. The window itself comes after its parts. */
    private static final List<String> PACKAGES = List.of(
            "property",
            "math",
            "ray",
            "spacetime",
            "light",
            "surface",
            "primitive",
            "search",
            "sceneobject",
            "shutter",
            "camera",
            "file",
            "image",
            "lesson",
            "studio",
            "world",
            "trace",
            "measure",
            "explain",
            "render",
            "io",
            "animation",
            "study",
            "lab",
            "ui.widget",
            "ui.model",
            "ui.file",
            "ui.number",
            "ui.picture",
            "ui.ray",
            "ui.compare",
            "ui.overlay",
            "ui.photograph",
            "ui.editor",
            "ui.exchange",
            "ui.panel",
            "ui.animate",
            "ui.ride",
            "ui.measure",
            "ui.lesson",
            "ui.help",
            "ui",
            "app");

    /** The packages whose records describe a scene. */
    private static final List<String> DESCRIPTIONS = List.of(
            "property", "spacetime", "light", "surface", "sceneobject", "shutter", "camera", "lesson", "studio");

    /** A sealed family that is computed from a velocity, not described, and so needs no default. */
    private static final String COMPUTED_FAMILY = "tompkins.spacetime.SpaceTimeTransformation";

    private static final int LONGEST_FILE = 400;
    private static final Pattern LEFT_OVER = Pattern.compile(".*(_old|Old|_copy|\\d)$");
    private static final Pattern WILDCARD_IMPORT = Pattern.compile("^\\s*import\\s.*\\*\\s*;.*");

    private static final Path SOURCES = Path.of(System.getProperty("basedir", ""), "src");
    private static final JavaClasses CLASSES = new ClassFileImporter()
            .withImportOption(place -> !place.contains("/test-classes/"))
            .importPackages("tompkins");

    /** What Java takes from the system, unless it is named as one parameter more. */
    private static final Set<Class<?>> OF_THE_SYSTEM = Set.of(Locale.class, Charset.class, ThreadFactory.class);

    @Test
    void rulesSeeTheProgram() {
        assertThat(CLASSES).hasSizeGreaterThan(50);
        assertThat(sourceFiles("main")).hasSizeGreaterThan(50);
        assertThat(defaultedRecords()).hasSizeGreaterThan(10);
    }

    @Test
    void everyClassLiesInAKnownPackage() {
        assertThat(CLASSES.stream().filter(type -> place(type) < 0)).isEmpty();
    }

    /** So there are no cycles, either. */
    @Test
    void packagesDoNotUseLaterOnes() {
        assertThat(CLASSES.stream()
                        .flatMap(type -> type.getDirectDependenciesFromSelf().stream())
                        .filter(use -> place(use.getTargetClass().getBaseComponentType()) > place(use.getOriginClass()))
                        .map(Dependency::getDescription))
                .isEmpty();
    }

    /** The place of its package in the order, or -1. */
    private static int place(JavaClass type) {
        return PACKAGES.indexOf(type.getPackageName().replaceFirst("^tompkins\\.", ""));
    }

    @Test
    void onlyKeysAsksForTheMenuKey() {
        // which fails without a display
        noClasses()
                .that()
                .doNotHaveFullyQualifiedName("tompkins.ui.widget.Keys")
                .should()
                .callMethodWhere(target(name("getMenuShortcutKeyMaskEx")))
                .check(CLASSES);
    }

    @Test
    void imageKnowsOnlyFilesAndRays() {
        noClasses()
                .that()
                .resideInAPackage(within("image"))
                .should()
                .dependOnClassesThat(resideInAPackage("tompkins..")
                        .and(DescribedPredicate.not(JavaClass.Predicates.resideInAnyPackage(
                                within(List.of("image", "file", "ray", "property"))))))
                .allowEmptyShould(true)
                .check(CLASSES);
    }

    /** Swing the window, AWT also pictures and charts, Jackson only files. */
    @ParameterizedTest
    @CsvSource({"javax.swing.., ui", "java.awt.., ui image study", "tools.jackson.., io"})
    void librariesAreKnownToFewPackages(String library, String packages) {
        classesOutside(packages.split(" "))
                .should()
                .dependOnClassesThat()
                .resideInAPackage(library)
                .check(CLASSES);
    }

    @Test
    void onlyTheApplicationPrintsAndExits() {
        classesOutside("app")
                .should()
                .accessField(System.class, "out")
                .orShould()
                .accessField(System.class, "err")
                .orShould()
                .callMethod(System.class, "exit", int.class)
                .orShould()
                .callMethodWhere(target(name("printStackTrace")).and(target(owner(assignableTo(Throwable.class)))))
                .check(CLASSES);
    }

    @Test
    void chanceHasASeed() {
        noClasses()
                .should()
                .callMethod(Math.class, "random")
                .orShould()
                .callConstructor(Random.class)
                .check(CLASSES);
    }

    /**
     * Locale, charset and thread factory are told, where Java can be told: those of the system are not the same
     * everywhere.
     */
    @Test
    void nothingIsLeftToTheSystem() {
        leavesNothingToTheSystem().check(CLASSES);
    }

    @Test
    @Thorough
    void testsLeaveNothingToTheSystemEither() {
        JavaClasses both = new ClassFileImporter().importPackages("tompkins");
        assertThat(both).hasSizeGreaterThan(CLASSES.size() + 50);
        leavesNothingToTheSystem().check(both);
    }

    private static ArchRule leavesNothingToTheSystem() {
        return noClasses()
                .should()
                .callCodeUnitWhere(DescribedPredicate.describe(
                        "a locale, a charset or a thread factory could be named",
                        call -> asksTheSystem(call.getTarget())))
                .orShould()
                .callMethod(String.class, "formatted", Object[].class);
    }

    @Test
    void picturesAreReadAndWrittenByANamedFormat() {
        // of several providers for one format the first may lose range or fail
        noClasses()
                .should()
                .callMethodWhere(target(owner(assignableTo(ImageIO.class))).and(target(name("read"))))
                .orShould()
                .callMethodWhere(target(owner(assignableTo(ImageIO.class))).and(target(name("write"))))
                .check(CLASSES);
    }

    @Test
    void nothingNeedsWhatThePackagesLack() {
        noClasses()
                .should()
                .dependOnClassesThat()
                .haveNameMatching("java\\.awt\\.(SplashScreen|image\\.(AffineTransform|Convolve|Lookup)Op)")
                .orShould()
                .dependOnClassesThat()
                .resideInAnyPackage("javax.sound..", "sun..", "com.sun..", "jdk.internal..")
                .check(CLASSES);
    }

    @Test
    void noStateIsShared() {
        fields().that().areStatic().should().beFinal().check(CLASSES);
    }

    /** A ray and a hit are values to everybody else, although their memory is used again. */
    @Test
    void onlyRaysChangeRays() {
        noClasses()
                .that()
                .resideOutsideOfPackage("tompkins.ray")
                .should()
                .setFieldWhere(DescribedPredicate.describe(
                        "it belongs to a ray or a hit",
                        access -> access.getTargetOwner().isEquivalentTo(Ray.class)
                                || access.getTargetOwner().isEquivalentTo(Hit.class)))
                .check(CLASSES);
    }

    @Test
    void nothingIsKeptUnderAnotherName() {
        assertThat(CLASSES.stream()
                        .filter(type -> !type.isAnonymousClass())
                        .map(JavaClass::getSimpleName)
                        .filter(LEFT_OVER.asMatchPredicate()))
                .isEmpty();
        assertThat(sourceFiles("")
                        .filter(file -> LEFT_OVER
                                .matcher(file.getFileName().toString().replace(".java", ""))
                                .matches()))
                .isEmpty();
    }

    @Test
    void filesAreShort() {
        assertThat(sourceFiles("main").filter(file -> lines(file).size() > LONGEST_FILE))
                .as("files of more than %d lines", LONGEST_FILE)
                .isEmpty();
    }

    @Test
    void importsNameTheirTypes() {
        assertThat(sourceFiles("")
                        .flatMap(file -> lines(file).stream()
                                .filter(WILDCARD_IMPORT.asMatchPredicate())
                                .map(line -> file + ": " + line)))
                .isEmpty();
    }

    @Test
    void descriptionsCannotBeChangedThroughTheirVectors() {
        assertThat(descriptionTypes()
                        .filter(Class::isRecord)
                        .flatMap(type -> Arrays.stream(type.getRecordComponents()))
                        .filter(component -> isMutableVector(component.getGenericType())))
                .extracting(
                        RecordComponent::toString,
                        component -> component.getDeclaringRecord().getName())
                .as("record components")
                .isEmpty();
        assertThat(descriptionTypes()
                        .flatMap(type -> Arrays.stream(type.getDeclaredFields()))
                        .filter(field -> Modifier.isPublic(field.getModifiers()))
                        .filter(field -> isMutableVector(field.getGenericType())))
                .as("public fields")
                .isEmpty();
    }

    @Test
    void everyDescribedTypeHasADefault() {
        assertThat(defaultedRecords().filter(Predicate.not(ArchitectureTest::hasDefault)))
                .as("records without a public static final DEFAULT of their own type")
                .isEmpty();
    }

    /**
     * Whether a method or constructor of Java has a sibling that is told one thing more, which it takes from the system
     * instead.
     */
    private static boolean asksTheSystem(CodeUnitAccessTarget target) {
        String room = target.getOwner().getPackageName();
        // Swing's is the locale of the window; files are read and written in UTF-8 on every system
        if (!room.startsWith("java.")
                || room.startsWith("java.awt")
                || target.getOwner().isEquivalentTo(Files.class)) {
            return false;
        }
        List<String> types =
                target.getRawParameterTypes().stream().map(JavaClass::getName).toList();
        Class<?> owner = target.getOwner().reflect();
        Stream<? extends Executable> all = target.getName().equals("<init>")
                ? Stream.of(owner.getConstructors())
                : Stream.of(owner.getMethods())
                        .filter(method -> method.getName().equals(target.getName()));
        return all.map(Executable::getParameterTypes)
                .filter(others -> others.length == types.size() + 1)
                .anyMatch(others -> IntStream.range(0, others.length)
                        .anyMatch(i -> OF_THE_SYSTEM.contains(others[i]) && types.equals(without(others, i))));
    }

    private static List<String> without(Class<?>[] types, int left) {
        return IntStream.range(0, types.length)
                .filter(i -> i != left)
                .mapToObj(i -> types[i].getName())
                .toList();
    }

    private static GivenClassesConjunction classesOutside(String... packages) {
        return noClasses().that().resideOutsideOfPackages(within(List.of(packages)));
    }

    private static String within(String name) {
        return "tompkins." + name + "..";
    }

    private static String[] within(List<String> names) {
        return names.stream().map(ArchitectureTest::within).toArray(String[]::new);
    }

    private static Stream<Class<?>> descriptionTypes() {
        return CLASSES.stream()
                .filter(JavaClass.Predicates.resideInAnyPackage(within(DESCRIPTIONS)))
                .map(JavaClass::reflect);
    }

    /** The records that a scene file can name: all that are permitted, at any depth, by a sealed interface. */
    private static Stream<Class<?>> defaultedRecords() {
        return descriptionTypes()
                .filter(Class::isInterface)
                .filter(type -> !type.getName().equals(COMPUTED_FAMILY))
                .flatMap(ArchitectureTest::permitted)
                .filter(Class::isRecord)
                .distinct();
    }

    private static Stream<Class<?>> permitted(Class<?> type) {
        Class<?>[] subtypes = type.getPermittedSubclasses();
        return subtypes == null
                ? Stream.empty()
                : Arrays.stream(subtypes).flatMap(subtype -> Stream.concat(Stream.of(subtype), permitted(subtype)));
    }

    private static boolean hasDefault(Class<?> type) {
        int constant = Modifier.PUBLIC | Modifier.STATIC | Modifier.FINAL;
        return Arrays.stream(type.getDeclaredFields())
                .filter(field -> field.getName().equals("DEFAULT"))
                .filter(field -> (field.getModifiers() & constant) == constant)
                .map(Field::getType)
                .anyMatch(type::equals);
    }

    /** Whether a type is, or holds, one of JOML's classes: all of them can be written to; its interfaces cannot. */
    private static boolean isMutableVector(Type type) {
        if (type instanceof ParameterizedType generic) {
            return Arrays.stream(generic.getActualTypeArguments()).anyMatch(ArchitectureTest::isMutableVector);
        }
        if (type instanceof WildcardType wildcard) {
            return Arrays.stream(wildcard.getUpperBounds()).anyMatch(ArchitectureTest::isMutableVector);
        }
        if (type instanceof GenericArrayType array) {
            return isMutableVector(array.getGenericComponentType());
        }
        if (type instanceof Class<?> plain) {
            Class<?> element = plain.isArray() ? plain.getComponentType() : plain;
            return element.getPackageName().equals("org.joml") && !element.isInterface();
        }
        return false;
    }

    /** The Java files of one source folder ("main", "test"), or of all (""). */
    private static Stream<Path> sourceFiles(String folder) {
        try (Stream<Path> files = Files.walk(SOURCES.resolve(folder))) {
            return files.filter(file -> file.toString().endsWith(".java")).toList().stream();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static List<String> lines(Path file) {
        try {
            return Files.readAllLines(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
