package tompkins.ui;

import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * A test that opens windows, or a class of such tests. Without a display it is skipped with all that prepares it and
 * tidies up after it; with {@code -Dtompkins.display=required} it fails instead.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@Tag("display")
@EnabledOnOs(value = OS.LINUX, disabledReason = "windows are tried on Linux: fonts, frames and focus differ elsewhere")
@ExtendWith(NeedsDisplay.Condition.class)
public @interface NeedsDisplay {

    /** Asks for the display. */
    final class Condition implements ExecutionCondition {

        private static final String HOW =
                "no display: run  xvfb-run -a -s \"-screen 0 1366x768x24\" mvn test -Dtompkins.display=required";

        @Override
        public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
            if (Displays.usable()) {
                OwnEvents.EVENTS.install();
                return ConditionEvaluationResult.enabled("there is a display");
            }
            if ("required".equals(System.getProperty("tompkins.display"))) {
                throw new AssertionError(HOW);
            }
            return ConditionEvaluationResult.disabled(HOW);
        }
    }
}
