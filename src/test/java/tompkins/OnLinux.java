package tompkins;

import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/**
 * A test, or a class of tests, that asks for what only Linux has in this form: its shell, devices, links, permissions,
 * or words for failures. It is skipped elsewhere.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@EnabledOnOs(
        value = OS.LINUX,
        disabledReason = "it asks for the shell, devices, links, permissions, names or messages of Linux")
public @interface OnLinux {}
