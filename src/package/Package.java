import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.stream.Stream;

/**
 * Makes a package for the system on which it runs: from {@code target/tompkins.jar} it makes, in {@code target/package}, a folder with
 * the program and its own Java machine, and an installer. {@code mvn -Ppackage -DskipTests verify} calls it.
 *
 * <p>The steps are the same on all systems: {@code jlink} makes the Java machine, and {@code jpackage} the folder and the installer.
 * What differs stands in {@link Target}.
 */
public final class Package {

    /** What {@code jpackage} is told for one system only: of the folder and the installer, and of the installer alone. */
    private enum Target {
        LINUX(
                List.of("--name", "tompkins", "--icon", "src/package/tompkins.png"),
                List.of("--type", "deb", "--install-dir", "/usr", "--license-file", "LICENSE", "--linux-app-category", "science",
                        "--linux-deb-maintainer", "maintainers@tompkins.invalid")),
        MAC(
                List.of("--name", "Tompkins", "--icon", "src/package/tompkins.icns"),
                List.of("--type", "dmg")),
        /** A program of Windows has a console or has none; names of the two differ in more than capitals. */
        WINDOWS(
                List.of("--name", "Tompkins Desktop", "--icon", "src/package/tompkins.ico",
                        "--add-launcher", "tompkins=src/package/windows/console.properties"),
                List.of("--type", "msi", "--install-dir", "Tompkins", "--win-per-user-install", "--win-dir-chooser",
                        "--win-menu", "--win-menu-group", "Tompkins", "--win-shortcut-prompt"));

        private final List<String> options;
        private final List<String> installer;

        Target(List<String> options, List<String> installer) {
            this.options = options;
            this.installer = installer;
        }

        static Target ofThisSystem() {
            String name = System.getProperty("os.name");
            return name.startsWith("Windows") ? WINDOWS : name.startsWith("Mac") ? MAC : LINUX;
        }
    }

    /** What jdeps finds in the jar, file systems in jars, and screen readers. */
    private static final String MODULES = "java.base,java.desktop,java.management,jdk.unsupported,jdk.zipfs,jdk.accessibility";

    /**
     * Libraries of sound, splash screens and filters of pictures, which the program may not use ({@code ArchitectureTest}), what other
     * Java machines read of this one, and whom to trust in a network, which the program does not use.
     */
    private static final String UNUSED_FILES =
            "**jsound*,**splashscreen*,**mlib_image*,**jrt-fs.jar,**cacerts,**public_suffix_list.dat";

    /** What XML and keytool say in other languages than English. */
    private static final String UNUSED_TRANSLATIONS = "regex:/(java.xml|java.base/sun/security/tools)/"
            + ".*_(ca|cs|de|es|fr|it|ja|ko|pt_BR|sk|sv|tr|zh|zh_CN|zh_HK|zh_TW)[.].*";

    /** While nothing happens, the memory that a picture took goes back to the system: half of what the window had at rest. */
    private static final String GIVES_MEMORY_BACK = "-XX:G1PeriodicGCInterval=5000 -XX:MinHeapFreeRatio=10 -XX:MaxHeapFreeRatio=20";

    private static final Path FOLDER = Path.of("target", "package").toAbsolutePath();
    private static final Path WORK = FOLDER.resolve("work");
    private static final Path INPUT = WORK.resolve("input");
    private static final Path JAR = INPUT.resolve("tompkins.jar");
    private static final Path RUNTIME = WORK.resolve("runtime");

    private Package() {}

    /** Makes the package; there are no arguments. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        delete(FOLDER);
        Files.createDirectories(INPUT);
        Files.copy(Path.of("target", "tompkins.jar"), JAR);
        run(tool("jlink"), "--add-modules", MODULES, "--strip-debug", "--no-header-files", "--no-man-pages", "--compress", "2",
                "--exclude-files", UNUSED_FILES, "--exclude-resources", UNUSED_TRANSLATIONS, "--output", RUNTIME.toString());
        Target target = Target.ofThisSystem();
        jpackage(target.options, List.of("--type", "app-image"));
        jpackage(target.options, target.installer);
        if (target == Target.LINUX) {
            run("sh", "src/package/linux/complete", FOLDER.toString());
        }
        delete(WORK);
    }

    private static void jpackage(List<String> options, List<String> more) throws IOException, InterruptedException {
        Attributes manifest;
        try (JarFile jar = new JarFile(JAR.toFile())) {
            manifest = jar.getManifest().getMainAttributes();
        }
        List<String> command = new ArrayList<>(List.of(
                tool("jpackage"), "--app-version", manifest.getValue(Attributes.Name.IMPLEMENTATION_VERSION),
                "--vendor", "The Tompkins authors",
                "--description", "Takes photographs with a camera that moves at nearly the speed of light",
                "--runtime-image", RUNTIME.toString(), "--input", INPUT.toString(), "--main-jar", JAR.getFileName().toString(),
                "--java-options", "--enable-native-access=ALL-UNNAMED " + GIVES_MEMORY_BACK,
                "--dest", FOLDER.toString()));
        command.addAll(options);
        command.addAll(more);
        run(command.toArray(String[]::new));
    }

    /** A tool of the Java machine that runs this. */
    private static String tool(String name) {
        return Path.of(System.getProperty("java.home"), "bin", name).toString();
    }

    private static void run(String... command) throws IOException, InterruptedException {
        System.out.println(String.join(" ", command));
        ProcessBuilder builder = new ProcessBuilder(command).inheritIO();
        // the package of Debian is packed once more by the last step: a minute less
        builder.environment().put("DPKG_DEB_COMPRESSOR_TYPE", "none");
        int code = builder.start().waitFor();
        if (code != 0) {
            throw new IOException(command[0] + " failed with exit code " + code);
        }
    }

    private static void delete(Path folder) throws IOException {
        if (Files.exists(folder)) {
            try (Stream<Path> all = Files.walk(folder)) {
                for (Path path : all.sorted(Comparator.reverseOrder()).toList()) {
                    // of what jlink writes, some may only be read, which Windows would not delete
                    path.toFile().setWritable(true);
                    Files.delete(path);
                }
            }
        }
    }
}
